// Grader of 06.gyroscopic_step: a step in fractions; what one turn of Newton's method leaves of a
// quadratic equation, which is known exactly; and the energy of a body that tumbles.

#include "carom/motion/gyroscopic_step.hpp"

#include <cmath>
#include <limits>

#include "carom/core/cross.hpp"
#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"
#include "grading/random.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

Matrix3 diagonal(Real a, Real b, Real c) {
  return Vector3(a, b, c).asDiagonal();
}

// A frame of three directions at right angles.
Matrix3 anyFrame(Random& random) {
  const Vector3 x = random.direction();
  const Vector3 across = cross(x, random.direction());
  const Vector3 y = across / std::sqrt(across.squaredNorm());
  Matrix3 frame;
  frame << x, y, cross(x, y);
  return frame;
}

// A body whose moments obey the triangle inequality.
Matrix3 anyInertia(Random& random) {
  const Real x = random.between(0.5, 2), y = random.between(0.5, 2), z = random.between(0.5, 2);
  const Matrix3 frame = anyFrame(random);
  return frame * diagonal(y + z, z + x, x + y) * frame.transpose();
}

// f is of second degree in w'. So what one turn of Newton's method leaves of f is the quadratic
// part of the change, dt u x I u, and nothing else: the rest must vanish.
Vector3 beyondTheTangent(const Matrix3& inertia, const Vector3& w, Real dt) {
  const Vector3 next = gyroscopicStep(inertia, w, dt), change = next - w;
  const Vector3 left = inertia * change + dt * cross(next, inertia * next);
  return left - dt * cross(change, inertia * change);
}

// What part of the energy is there after some seconds of tumbling at 60 steps a second.
Real energyLeft(const Vector3& moments, const Vector3& start, Real seconds) {
  const auto energy = [&](const Vector3& w) { return moments.dot(w.cwiseProduct(w)) / 2; };
  const Matrix3 inertia = moments.asDiagonal();
  Vector3 w = start;
  for (int i = 0; i < seconds * 60; ++i) w = gyroscopicStep(inertia, w, 1.0 / 60);
  return energy(w) / energy(start);
}

}  // namespace

TEST_CASE("example") {
  const Matrix3 inertia = diagonal(1, 2, 3);
  const Vector3 w(1, 1, 1);
  GRADE(gyroscopicStep(inertia, w, 0.1), Vector3(2709.0 / 3028, 3289.0 / 3028, 2929.0 / 3028),
        within(1e-15, kRounding), given("inertia", inertia, "kg m^2"),
        given("angularVelocity", w, "rad/s"), given("dt", 0.1, "s"), unit("rad/s"),
        about("moments of 1, 2 and 3 kg m^2, turning at 1 rad/s about each axis"));
}

TEST_CASE("tangent") {
  Random random(seed());
  for (int n = 0; n < 15; ++n) {
    const Matrix3 inertia = anyInertia(random);
    const Vector3 w = 2 * random.direction();
    const Real dt = random.between(0.02, 0.2);
    GRADE(beyondTheTangent(inertia, w, dt), Vector3(0, 0, 0), within(1e-13, kRounding),
          given("inertia", inertia, "kg m^2"), given("angularVelocity", w, "rad/s"),
          given("dt", dt, "s"), given("your answer", gyroscopicStep(inertia, w, dt), "rad/s"),
          unit("kg m^2 rad/s"),
          about("with u = w' - w: f(w') - dt u x I u, which Newton's method makes zero"));
  }
}

TEST_CASE("energy") {
  const Vector3 moments(1, 2, 3), w(0.3, 1.9, 0.5);
  GRADE(energyLeft(moments, w, 10), 0.85, within(0.15, "it loses some, and gains none"),
        given("moments", moments, "kg m^2"), given("angularVelocity", w, "rad/s"),
        about("what part of its energy a tumbling body has after ten seconds, at 60 steps a "
              "second"));
  GRADE(energyLeft({3, 1, 1.5}, {1, 1, 2}, 10), 0.85, within(0.15, "it loses some, and gains none"),
        given("moments", Vector3(3, 1, 1.5), "kg m^2"),
        given("angularVelocity", Vector3(1, 1, 2), "rad/s"), about("the same for another body"));
}

TEST_CASE("still") {
  const Matrix3 inertia = diagonal(1, 2, 3);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 w = 3 * Vector3::Unit(axis);
    GRADE(gyroscopicStep(inertia, w, 0.1), w, within(1e-15, kRounding),
          given("inertia", inertia, "kg m^2"), given("angularVelocity", w, "rad/s"),
          given("dt", 0.1, "s"), unit("rad/s"), about("it turns about one of its axes"));
  }
}

TEST_CASE("refuses") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  GRADE_REFUSES(gyroscopicStep(diagonal(1, 2, 3), {1, nan, 0}, 0.1),
                given("angularVelocity", Vector3(1, nan, 0), "rad/s"));
}

PROBES() {
  Random random(608);
  for (int n = 0; n < 16; ++n) {
    const Matrix3 inertia = anyInertia(random);
    const Vector3 w = 2 * random.direction();
    PROBE(gyroscopicStep(inertia, w, random.between(0.05, 0.2)));
  }
}
