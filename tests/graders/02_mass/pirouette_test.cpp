// Grader of 02.pirouette: the library puts the skater together from a cylinder and two small balls.

#include <array>

#include "carom/mass/combine_bodies.hpp"
#include "carom/mass/standard_solids.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kRateBefore = 3;  // [rad/s]

MassProperties scaled(MassProperties body, Real mass) {
  body.inertia *= mass / body.mass;
  body.mass = mass;
  return body;
}

// The moment about the upright axis with both weights at a distance from it [kg m²].
Real momentWithWeightsAt(Real distance) {
  const MassProperties trunk = scaled(solidCylinder(0.2, 1.7, 1), 60);
  MassProperties left = scaled(solidBall(0.001, 1), 2);
  left.center.x() = -distance;
  MassProperties right = left;
  right.center.x() = distance;
  return combineBodies(std::array{trunk, left, right}).inertia(2, 2);
}

const Real before = momentWithWeightsAt(0.8);
const Real after = momentWithWeightsAt(0.2);
const Real rateAfter = before * kRateBefore / after;  // the angular momentum stays

}  // namespace

TEST_CASE("rate") {
  GRADE(predicted("rate_after", "rad/s"), rateAfter,
        withinRelative(0.05, "a prediction may be 5% off"), unit("rad/s"),
        about("how fast she turns with the weights close"));
}

TEST_CASE("energy") {
  const Real energyBefore = before * kRateBefore * kRateBefore / 2;
  const Real energyAfter = after * rateAfter * rateAfter / 2;
  GRADE(predicted("energy_after", "J"), energyAfter,
        withinRelative(0.05, "a prediction may be 5% off"), unit("J"),
        about("the energy of the turning with the weights close"));
  GRADE(predicted("work_of_the_arms", "J"), energyAfter - energyBefore,
        withinRelative(0.05, "a prediction may be 5% off"), unit("J"),
        about("the work of pulling the weights in"));
}

PROBES() {
  PROBE(predicted("rate_after", "rad/s"));
  PROBE(predicted("energy_after", "J"));
  PROBE(predicted("work_of_the_arms", "J"));
}
