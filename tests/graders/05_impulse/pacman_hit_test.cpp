// Grader of 05.pacman_hit: the library puts the two halves together, hits them, and looks how the
// middle of the disc moves.

#include <array>
#include <cmath>
#include <numbers>

#include "carom/impulse/apply_impulse.hpp"
#include "carom/impulse/point_velocity.hpp"
#include "carom/mass/combine_bodies.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kMargin = "a prediction may be 5% off";

// A sector of a disc of 1 m and 1 kg/m^2 that spans 150 degrees, its middle at an angle. Flat, so
// about axes in its plane it has some moment that nobody asks for.
MassProperties half(Real angle) {
  const Real halfSpan = 5 * std::numbers::pi / 12;
  const Real distance = 2 * std::sin(halfSpan) / (3 * halfSpan);
  MassProperties part;
  part.mass = halfSpan;
  part.volume = halfSpan;
  part.center = distance * Vector3(std::cos(angle), std::sin(angle), 0);
  const Real aboutItsCenter = part.mass / 2 - part.mass * distance * distance;
  part.inertia = Vector3(aboutItsCenter / 2, aboutItsCenter / 2, aboutItsCenter).asDiagonal();
  return part;
}

struct Hit {
  Velocity velocity;  // of the centre of mass
  Vector3 middle;     // velocity of the middle of the disc
};

Hit hitOnTheHead() {
  const Real tilt = 5 * std::numbers::pi / 12;
  const MassProperties whole = combineBodies(std::array{half(tilt), half(-tilt)});
  OrientedBody nobody, pacman = orientedBody(whole, Matrix3::Identity(), {});
  applyImpulse(nobody, {0, 0, 0}, pacman, Vector3(0, 1, 0) - whole.center, {1, 0, 0});
  return {pacman.velocity, pointVelocity(pacman.velocity, -whole.center)};
}

}  // namespace

TEST_CASE("flies") {
  GRADE(predicted("speed_to_the_right", "m/s"), hitOnTheHead().velocity.linear.x(),
        withinRelative(0.05, kMargin), unit("m/s"),
        about("how fast his centre of mass moves to the right"));
}

TEST_CASE("turns") {
  GRADE(predicted("turning_clockwise", "rad/s"), -hitOnTheHead().velocity.angular.z(),
        withinRelative(0.05, kMargin), unit("rad/s"),
        about("how fast he turns, clockwise positive"));
}

TEST_CASE("middle") {
  GRADE(predicted("middle_upwards", "m/s"), hitOnTheHead().middle.y(),
        withinRelative(0.05, kMargin), unit("m/s"),
        about("how fast the middle of the disc moves upwards"));
}

PROBES() {
  PROBE(predicted("speed_to_the_right", "m/s"));
  PROBE(predicted("turning_clockwise", "rad/s"));
  PROBE(predicted("middle_upwards", "m/s"));
}
