// Grader of 01.matrix_to_euler: matrices made from known angles as a product of three turns. Where the
// angles are not unique, the matrix made from the answer must be the one that was asked about.

#include "carom/rotation/matrix_to_euler.hpp"

#include <cmath>

#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kQuarter = 1.57079632679489661923;  // [rad]

// A turn about one of the coordinate axes, which leaves the other two in a plane.
Matrix3 turnAbout(int axis, Real angle) {
  const int from = (axis + 1) % 3;
  const int to = (axis + 2) % 3;
  Matrix3 turn = Matrix3::Identity();
  turn(from, from) = turn(to, to) = std::cos(angle);
  turn(to, from) = std::sin(angle);
  turn(from, to) = -turn(to, from);
  return turn;
}

Matrix3 matrixOf(const EulerAngles& angles) {
  return turnAbout(2, angles.yaw) * turnAbout(1, angles.pitch) * turnAbout(0, angles.roll);
}

// Entries with 16 digits behind the point, as any computed rotation has them: near the lock that is
// what is left of roll and yaw.
Matrix3 rounded(const Matrix3& R) {
  return R.unaryExpr([](Real entry) { return std::nearbyint(entry * 0x1p53) * 0x1p-53; });
}

// Pitch exactly a quarter turn up or down; only the angle between the other two is left.
Matrix3 lockedUp(Real rollMinusYaw) {
  const Real s = std::sin(rollMinusYaw), c = std::cos(rollMinusYaw);
  Matrix3 R;
  R << 0, s, c, 0, c, -s, -1, 0, 0;
  return R;
}
Matrix3 lockedDown(Real rollPlusYaw) {
  const Real s = std::sin(rollPlusYaw), c = std::cos(rollPlusYaw);
  Matrix3 R;
  R << 0, -s, -c, 0, c, -s, 1, 0, 0;
  return R;
}

Matrix3 rebuilt(const Matrix3& R) {
  return matrixOf(matrixToEuler(R));
}

void asksAngles(const EulerAngles& angles) {
  const Matrix3 R = matrixOf(angles);
  GRADE(matrixToEuler(R), angles,
        within(4e-15, "rounding of the entries, divided by cos pitch of 0.36 or more"),
        given("R", R), unit("rad"));
}

}  // namespace

TEST_CASE("angles") {
  asksAngles({.roll = 0.3, .pitch = -0.7, .yaw = 1.1});
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const Real roll = random.between(-1.5, 1.5);
    const Real pitch = random.between(-1.2, 1.2);
    asksAngles({roll, pitch, random.between(-1.5, 1.5)});
  }
}

TEST_CASE("quadrants") {
  asksAngles({.roll = 2.5, .pitch = 0.4, .yaw = -2.8});
  asksAngles({.roll = -1.7, .pitch = -1.1, .yaw = 1.8});
  asksAngles({.roll = 3, .pitch = 0, .yaw = 0.2});
  asksAngles({.roll = 0.1, .pitch = 0.2, .yaw = 3});
}

TEST_CASE("near") {
  // 1 - cos(x) is below the last digit of 1 for these.
  for (const Real x : {1e-3, 1e-6, 1e-8, 1e-11}) {
    for (const Real sign : {1.0, -1.0}) {
      const EulerAngles angles{.roll = 0.4, .pitch = sign * (kQuarter - x), .yaw = 1.3};
      const Matrix3 R = matrixOf(angles);
      GRADE(matrixToEuler(R).pitch, angles.pitch,
            within(1e-14, "a few roundings of the sine and the cosine of pitch"), given("R", R),
            unit("rad"), about("pitch, this close to a quarter turn"));
    }
  }
}

TEST_CASE("lock") {
  const Matrix3 up = lockedUp(0.7);
  GRADE(matrixToEuler(up), (EulerAngles{0, kQuarter, -0.7}),
        within(1e-14, "a few roundings of sines and cosines"), given("R", up), unit("rad"),
        about("pitch is a quarter turn up, roll - yaw = 0.7 rad"));
  const Matrix3 down = lockedDown(2.2);
  GRADE(matrixToEuler(down), (EulerAngles{0, -kQuarter, 2.2}),
        within(1e-14, "a few roundings of sines and cosines"), given("R", down), unit("rad"),
        about("pitch is a quarter turn down, roll + yaw = 2.2 rad"));
  Random random(seed());
  for (int n = 0; n < 40; ++n) {
    const Real roll = random.between(-3, 3);
    const Real fromLock = std::pow(10, random.between(-16, -3));
    const Real sign = n % 2 ? 1 : -1;
    const Matrix3 R =
        rounded(matrixOf({roll, sign * (kQuarter - fromLock), random.between(-3, 3)}));
    GRADE(rebuilt(R), R, within(1e-7, "ten times what a branch below cos pitch = 1e-8 costs"),
          given("R", R), about("the matrix made from the angles that you found"));
  }
}

PROBES() {
  Random random(12);
  for (int n = 0; n < 16; ++n) {
    const Real roll = random.between(-3, 3);
    const Real pitch = random.between(-1.4, 1.4);
    PROBE(matrixToEuler(matrixOf({roll, pitch, random.between(-3, 3)})));
  }
  for (const Real angle : {0.7, -2.5}) {
    PROBE(matrixToEuler(lockedUp(angle)));
    PROBE(matrixToEuler(lockedDown(angle)));
    // Roll and yaw themselves are noise here, but pitch is not.
    PROBE(matrixToEuler(matrixOf({angle, kQuarter - 1e-8, 0.3})).pitch);
  }
}
