// Grader of 02.pushed_rod: the library weighs the rod as a thin box and moves the axis to the
// hinge.

#include "carom/mass/box_inertia.hpp"
#include "carom/mass/parallel_axis.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kMass = 3;      // [kg]
constexpr Real kLength = 2;    // [m]
constexpr Real kForce = 1;     // [N]
constexpr Real kArm = 0.8;     // from the centre of the rod to the push [m]
constexpr Real kThin = 0.001;  // thickness of the rod [m]

const Matrix3 aboutCenter = boxInertia(kMass, {kLength, kThin, kThin});
const Matrix3 aboutHinge = parallelAxis(aboutCenter, kMass, {kLength / 2, 0, 0});

}  // namespace

TEST_CASE("free") {
  GRADE(predicted("free_acceleration", "m/s^2"), kForce / kMass,
        withinRelative(0.05, "a prediction may be 5% off"), unit("m/s^2"),
        about("of the centre of the free rod"));
  GRADE(predicted("free_angular_acceleration", "rad/s^2"), kForce * kArm / aboutCenter(2, 2),
        withinRelative(0.05, "a prediction may be 5% off"), unit("rad/s^2"),
        about("of the free rod"));
}

TEST_CASE("hinged") {
  GRADE(predicted("hinged_angular_acceleration", "rad/s^2"),
        kForce * (kLength / 2 + kArm) / aboutHinge(2, 2),
        withinRelative(0.05, "a prediction may be 5% off"), unit("rad/s^2"),
        about("of the rod on its hinge"));
}

PROBES() {
  PROBE(predicted("free_acceleration", "m/s^2"));
  PROBE(predicted("free_angular_acceleration", "rad/s^2"));
  PROBE(predicted("hinged_angular_acceleration", "rad/s^2"));
}
