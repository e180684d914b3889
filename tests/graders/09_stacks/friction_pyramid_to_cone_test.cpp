// Grader of 09.friction_pyramid_to_cone: Coulomb's law, direction by direction.

#include "carom/solver/friction_pyramid_to_cone.hpp"

#include <cmath>
#include <numbers>

#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const Within kClose = within(1e-12, "a handful of operations");

Vector2 towards(Real degrees, Real length) {
  const Real angle = degrees * std::numbers::pi / 180;
  return {length * std::cos(angle), length * std::sin(angle)};
}

void ask(const Vector2& friction, const Vector2& slip, Real mass, Real limit,
         const Vector2& expected, const char* what) {
  GRADE(frictionPyramidToCone(friction, slip, mass, limit), expected, kClose,
        given("friction", friction, "N s"), given("slip", slip, "m/s"), given("mass", mass, "kg"),
        given("limit", limit, "N s"), unit("N s"), about(what));
}

}  // namespace

TEST_CASE("askew") {
  ask(Vector2::Zero(), {3, 4}, 2, 5, {-3, -4},
      "a block slides askew: against the slip, 5 N s long");
  ask(Vector2::Zero(), {3, -3}, 1, 0.5, towards(135, 0.5), "along the diagonal");
  Random random(seed());
  for (int n = 0; n < 5; ++n) {
    const Real degrees = 90 * n + random.between(20, 70);
    const Real limit = random.between(0.2, 0.8);
    ask(Vector2::Zero(), towards(degrees, 4), 2, limit, towards(degrees + 180, limit),
        "slides fast, in a direction askew");
  }
}

TEST_CASE("sticks") {
  ask(Vector2::Zero(), {0.1, -0.2}, 2, 1, {-0.2, 0.4}, "a slow slip is stopped");
  ask({0.3, 0.1}, {0, 0}, 2, 1, {0.3, 0.1}, "what sticks goes on to be held as it is");
  ask({0.3, 0.1}, {0.2, 0.1}, 1, 1, {0.1, 0}, "what was too much is taken back");
}

TEST_CASE("sum") {
  ask({-0.9, 0}, {1, 0}, 0.5, 1, {-1, 0}, "nearly at the limit already, and still slipping");
  ask({0.6, 0}, {0, -2}, 0.4, 0.8, {0.48, 0.64}, "the sum has its direction from both");
  ask({-0.5, 0.2}, {1, 1}, 0.25, 0, {0, 0}, "nothing presses any more");
}

TEST_CASE("refuses") {
  GRADE_REFUSES(frictionPyramidToCone({0, 0}, {1, 0}, -1, 1), given("mass", -1.0, "kg"));
  GRADE_REFUSES(frictionPyramidToCone({0, 0}, {1, 0}, 1, -1), given("limit", -1.0, "N s"));
}

PROBES() {
  Random random(940);
  for (int n = 0; n < 24; ++n) {
    const Real x = random.between(-1, 1), y = random.between(-1, 1);
    const Real u = random.between(-2, 2), v = random.between(-2, 2);
    const Real limit = random.between(0.2, 3);
    PROBE(frictionPyramidToCone({x, y}, {u, v}, random.between(0.2, 1), limit));
  }
}
