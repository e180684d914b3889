// Grader of 01.euler_to_matrix: where the matrix takes points whose way is known without any matrix.
// The x axis of the body is a point on the globe, of longitude yaw and latitude -pitch; the direction
// that roll brings to the horizon follows yaw alone. Together with the determinant this is all of R.

#include "carom/rotation/euler_to_matrix.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kQuarter = 1.57079632679489661923;  // [rad]
constexpr const char* kRounding =
    "entries up to 1, each from three rounded products of rounded sines and cosines";

const Vector3 ex(1, 0, 0);
const Vector3 ey(0, 1, 0);
const Vector3 ez(0, 0, 1);

Vector3 turned(const EulerAngles& angles, const Vector3& point) {
  return eulerToMatrix(angles) * point;
}

Real determinant(const Matrix3& R) {
  return cross(R.col(0), R.col(1)).dot(R.col(2));
}

EulerAngles anyAngles(Random& random) {
  const Real roll = random.between(-3, 3);
  const Real pitch = random.between(-3, 3);
  return {roll, pitch, random.between(-3, 3)};
}

void asksWhere(const EulerAngles& angles, const Vector3& point, const Vector3& expected) {
  GRADE(turned(angles, point), expected, within(1e-15, kRounding), given("angles", angles, "rad"),
        given("point", point), about("where does the matrix take this point?"));
}

}  // namespace

TEST_CASE("axes") {
  // A quarter turn of each angle alone.
  asksWhere({.roll = kQuarter}, ey, ez);
  asksWhere({.roll = kQuarter}, ez, {0, -1, 0});
  asksWhere({.pitch = kQuarter}, ez, ex);
  asksWhere({.pitch = kQuarter}, ex, {0, 0, -1});
  asksWhere({.yaw = kQuarter}, ex, ey);
  asksWhere({.yaw = kQuarter}, ey, {-1, 0, 0});
}

TEST_CASE("order") {
  // Two quarter turns, which take an axis to an axis; the other order takes it to another one.
  asksWhere({.roll = kQuarter, .pitch = kQuarter}, ez, {0, -1, 0});
  asksWhere({.pitch = kQuarter, .yaw = kQuarter}, ex, {0, 0, -1});
  asksWhere({.roll = kQuarter, .yaw = kQuarter}, ey, ez);
}

TEST_CASE("entries") {
  // Reference values with 25 digits, and no turn at all.
  const EulerAngles angles{.roll = 0.3, .pitch = -0.7, .yaw = 1.1};
  Matrix3 expected;
  expected << 0.3469294496548990137409262, -0.9377582425124972266106812,
      -0.01579352911864000775876256,                                                          //
      0.6816329865934228390993425, 0.263669453487192289362058, -0.6825356334181358929871926,  //
      0.6442176872376910536726144, 0.2260263212496230074930953, 0.7306816499355124000997317;
  GRADE(eulerToMatrix(angles), expected, within(1e-15, kRounding), given("angles", angles, "rad"));
  const EulerAngles none;
  GRADE(eulerToMatrix(none), Matrix3::Identity(),
        within(0, "sines of 0 and cosines of 0 are exact"), given("angles", none, "rad"),
        about("no turn at all"));
}

TEST_CASE("everywhere") {
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const EulerAngles a = anyAngles(random);
    asksWhere(a, ex,
              {std::cos(a.yaw) * std::cos(a.pitch), std::sin(a.yaw) * std::cos(a.pitch),
               -std::sin(a.pitch)});
    asksWhere(a, {0, std::cos(a.roll), -std::sin(a.roll)}, {-std::sin(a.yaw), std::cos(a.yaw), 0});
    GRADE(determinant(eulerToMatrix(a)), 1, within(2e-15, kRounding), given("angles", a, "rad"),
          about("the volume of a unit cube after the turn"));
    GRADE(turned(a, ex).dot(turned(a, ey)), 0, within(1e-15, kRounding), given("angles", a, "rad"),
          about("turned axes still stand at right angles"));
  }
}

PROBES() {
  Random random(11);
  for (int n = 0; n < 20; ++n) PROBE(eulerToMatrix(anyAngles(random)));
}
