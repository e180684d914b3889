// Grader of 05.angular_acceleration: bodies along their principal axes, the same bodies seen along
// other axes, and the angular momentum in space a moment before and a moment after.

#include "carom/impulse/angular_acceleration.hpp"

#include "graders/05_impulse/bodies.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

Matrix3 diagonal(Real xx, Real yy, Real zz) {
  return Vector3(xx, yy, zz).asDiagonal();
}

void ask(const Matrix3& inertia, const Vector3& w, const Vector3& torque, const Vector3& expected,
         const Within& within, const char* what) {
  GRADE(angularAcceleration(inertia, w, torque), expected, within,
        given("inertia", inertia, "kg m^2"), given("angularVelocity", w, "rad/s"),
        given("torque", torque, "N m"), unit("rad/s^2"), about(what));
}

// Along principal axes there is one equation per axis: each rate is driven by the other two and by
// the difference of their moments.
Vector3 alongPrincipalAxes(const Vector3& I, const Vector3& w, const Vector3& torque) {
  return {(torque.x() + (I.y() - I.z()) * w.y() * w.z()) / I.x(),
          (torque.y() + (I.z() - I.x()) * w.z() * w.x()) / I.y(),
          (torque.z() + (I.x() - I.y()) * w.x() * w.y()) / I.z()};
}

struct Turning {
  Matrix3 inertia = Matrix3::Identity();
  Vector3 w = Vector3::Zero(), torque = Vector3::Zero();
  Vector3 expected = Vector3::Zero();
};

// A body that is described along axes askew to its principal ones.
Turning anyTurning(Random& random) {
  const Solid solid = anySolid(random);
  const Vector3 w = random.vector(4), torque = random.vector(3);
  Turning turning;
  turning.inertia = solid.inertia();
  turning.inertia = (turning.inertia + turning.inertia.transpose()).eval() / 2;
  turning.w = solid.axes * w;
  turning.torque = solid.axes * torque;
  turning.expected = solid.axes * alongPrincipalAxes(solid.moments, w, torque);
  return turning;
}

// The change of the angular momentum in space, per second: what the body's axes show at +h and
// -h, turned into space, where the body has turned by w h. In the middle its axes are space's.
// Squares of h cancel, and what is left is below h^2.
Vector3 changeInSpace(const Matrix3& inertia, const Vector3& w, const Vector3& acceleration) {
  constexpr Real h = 1e-4;
  const Vector3 axis = w.normalized();
  const Matrix3 later = turn(axis, h * w.norm()), earlier = turn(axis, -h * w.norm());
  return (later * (inertia * (w + h * acceleration)) -
          earlier * (inertia * (w - h * acceleration))) /
         (2 * h);
}

}  // namespace

TEST_CASE("torque") {
  ask(diagonal(1, 2, 4), {0, 0, 0}, {3, 3, 3}, {3, 1.5, 0.75}, within(1e-15, kRounding),
      "at rest: the larger the moment, the slower");
  ask(diagonal(0.5, 0.5, 0.5), {1, 2, 3}, {1, 0, -2}, {2, 0, -4}, within(1e-15, kRounding),
      "a ball turns about every axis alike");
  ask(diagonal(1, 2, 4), {0, 5, 0}, {0, 2, 0}, {0, 1, 0}, within(1e-15, kRounding),
      "the torque is along the axis of the rotation");
}

TEST_CASE("free") {
  ask(diagonal(1, 2, 3), {2, 0, 1.5}, {0, 0, 0}, {0, 3, 0}, within(1e-15, kRounding),
      "nothing acts on a body with three moments");
  ask(diagonal(2, 2, 1), {1, 0, 4}, {0, 0, 0}, {0, -2, 0}, within(1e-15, kRounding),
      "nothing acts on a slender top: its axis goes round");
  ask(diagonal(1, 2, 3), {1, 2, 3}, {0, 0, 0}, {-6, 3, -2.0 / 3}, within(2e-15, kRounding),
      "nothing acts, and it turns about all three axes at once");
}

TEST_CASE("skew") {
  Matrix3 I;
  I << 2, -1, 0, -1, 2, 0, 0, 0, 1;  // moments 1 and 3 along the diagonals of the plane
  ask(I, {0, 0, 0}, {3, 0, 0}, {2, 1, 0}, within(1e-14, kRounding),
      "a torque about x turns a skew body about y as well");
  ask(I, {1, 1, 0}, {0, 0, 0}, {0, 0, 0}, within(1e-14, kRounding),
      "it turns about a principal axis: nothing changes");
  Random random(seed());
  for (int n = 0; n < 15; ++n) {
    const Turning t = anyTurning(random);
    ask(t.inertia, t.w, t.torque, t.expected, withinRelative(1e-12, kRounding),
        "any body, described along axes that are not its principal ones");
  }
}

TEST_CASE("any") {
  Random random(seed() + 1);
  for (int n = 0; n < 15; ++n) {
    const Turning turning = anyTurning(random);
    const Matrix3 inertia = turning.inertia;
    const Vector3 w = turning.w, torque = turning.torque;
    GRADE(changeInSpace(inertia, w, angularAcceleration(inertia, w, torque)), torque,
          within(1e-4, "it is measured over 2e-4 s"), given("inertia", inertia, "kg m^2"),
          given("angularVelocity", w, "rad/s"), given("torque", torque, "N m"), unit("N m"),
          about("the angular momentum in space, its change per second"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(angularAcceleration(diagonal(1, 2, 0), {1, 0, 0}, {0, 0, 0}),
                given("inertia", diagonal(1, 2, 0), "kg m^2"));
  GRADE_REFUSES(angularAcceleration(diagonal(1, -2, 2), {1, 0, 0}, {0, 0, 0}),
                given("inertia", diagonal(1, -2, 2), "kg m^2"));
}

PROBES() {
  Random random(512);
  for (int n = 0; n < 16; ++n) {
    const Turning t = anyTurning(random);
    PROBE(angularAcceleration(t.inertia, t.w, t.torque));
  }
}
