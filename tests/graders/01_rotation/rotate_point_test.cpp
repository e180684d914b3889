// Grader of 01.rotate_point: points whose way is known, distances and angles that a turn keeps, the axis
// that it leaves alone, and turns composed of two. No quaternion multiplies a point here.

#include "carom/rotation/rotate_point.hpp"

#include <cmath>

#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const Real h = std::sqrt(0.5);
const Quaternion quarterX{h, h, 0, 0};
const Quaternion quarterY{h, 0, h, 0};
const Quaternion quarterZ{h, 0, 0, h};
constexpr const char* kRounding = "two products of quaternions: some ten roundings of each number";

Quaternion times(Real factor, const Quaternion& q) {
  return {factor * q.w, factor * q.x, factor * q.y, factor * q.z};
}

void asksWhere(const Quaternion& q, const Vector3& v, const Vector3& expected,
               const char* question = "where does the rotation take this point?") {
  GRADE(rotatePoint(q, v), expected, withinRelative(3e-15, kRounding), given("q", q), given("v", v),
        about(question));
}

}  // namespace

TEST_CASE("quarter") {
  asksWhere(quarterZ, {1, 0, 0}, {0, 1, 0});
  asksWhere(quarterX, {0, 1, 0}, {0, 0, 1});
  asksWhere(quarterY, {0, 0, 1}, {1, 0, 0});
  asksWhere(quarterZ, {1, 2, 3}, {-2, 1, 3});
}

TEST_CASE("any_turn") {
  asksWhere({0.3153223623952686654475386, 0.2536268079247632993198956, 0.5072536158495265986397912,
             0.7608804237742898979596869},
            {0.3, -1.2, 2.5},
            {1.829940051431098942900212, 2.094908531362239891730862, -0.2065857047185262421206455});
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const Vector3 axis = random.direction();
    const Real angle = random.between(-6, 6);
    const Vector3 u = std::sin(angle / 2) * axis;
    const Quaternion q{std::cos(angle / 2), u.x(), u.y(), u.z()};
    const Vector3 v = random.vector(3);
    asksWhere(q, axis, axis, "the axis of a turn does not move");
    GRADE(rotatePoint(q, v).squaredNorm(), v.squaredNorm(), withinRelative(5e-15, kRounding),
          given("q", q), given("v", v), about("the square of the distance from the centre"));
    // The part across the axis turns by the angle: its cosine is left in this product.
    const Vector3 across = v - axis.dot(v) * axis;
    GRADE(rotatePoint(q, across).dot(across), std::cos(angle) * across.squaredNorm(),
          within(5e-14, kRounding), given("q", q), given("v", across),
          about("turned point . point, for a point across the axis"));
  }
}

TEST_CASE("length") {
  asksWhere({1, 2, -2, 4}, {1, 0, 0}, {-0.6, 0, 0.8}, "this quaternion has the length 5");
  asksWhere(times(3, quarterX), {0, 2, 0}, {0, 0, 2});
  asksWhere(times(0.01, quarterY), {0, 0, 2}, {2, 0, 0});
  asksWhere(times(-7, quarterZ), {1, 2, 3}, {-2, 1, 3});
}

TEST_CASE("refuses") {
  const Quaternion zero{0, 0, 0, 0};
  const Vector3 v(1, 2, 3);
  GRADE_REFUSES(rotatePoint(zero, v), given("q", zero), given("v", v));
}

PROBES() {
  Random random(15);
  for (int n = 0; n < 20; ++n) {
    const Vector3 u = random.vector(2);
    const Vector3 v = random.vector(2);
    PROBE(rotatePoint({random.between(-2, 2), u.x(), u.y(), u.z()}, v));
  }
  PROBE(rotatePoint({0, 0, 0, 0}, {1, 2, 3}));
}
