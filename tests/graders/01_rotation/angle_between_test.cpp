// Grader of 01.angle_between: pairs of orientations made by a turn of a known angle.

#include "angle_between.hpp"

#include <cmath>

#include "carom/rotation/hamilton_product.hpp"
#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kHalfTurn = 3.14159265358979323846;  // [rad]
constexpr const char* kRounding = "a handful of roundings of numbers up to 1, doubled";

Quaternion turnAbout(const Vector3& axis, Real angle) {
  const Vector3 u = std::sin(angle / 2) * axis;
  return {std::cos(angle / 2), u.x(), u.y(), u.z()};
}

Quaternion times(Real factor, const Quaternion& q) {
  return {factor * q.w, factor * q.x, factor * q.y, factor * q.z};
}

void asks(const Quaternion& a, const Quaternion& b, Real expected, const char* question) {
  GRADE(angleBetween(a, b), expected, within(6e-15, kRounding), given("a", a), given("b", b),
        unit("rad"), about(question));
}

struct Pair {
  Quaternion a;
  Quaternion b;
};

// An orientation, and the one that a turn about any axis makes of it.
Pair anyPair(Random& random, Real angle) {
  const Quaternion a = turnAbout(random.direction(), random.between(0.5, 5));
  const Quaternion turn = turnAbout(random.direction(), angle);
  return {a, hamiltonProduct(turn, a)};
}

}  // namespace

TEST_CASE("other_sign") {
  Random random(seed());
  const Quaternion none{1, 0, 0, 0};
  asks(none, times(-1, turnAbout({0, 0, 1}, 0.5)), 0.5, "half a radian apart, with a sign changed");
  for (int n = 0; n < 20; ++n) {
    const Real angle = random.between(0.1, 3);
    const Pair pair = anyPair(random, angle);
    asks(pair.a, times(-1, pair.b), angle, "b is given with its other sign");
  }
}

TEST_CASE("small") {
  for (const Real angle : {1e-3, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const Quaternion none{1, 0, 0, 0};
    const Quaternion b = turnAbout({0, 0.6, 0.8}, angle);
    GRADE(angleBetween(none, b), angle,
          withinRelative(1e-13, "the sine of a small angle keeps its digits"), given("a", none),
          given("b", b), unit("rad"), about("a small turn away from no turn"));
  }
  // Elsewhere the numbers of a and b are rounded, and that is 1e-16 rad.
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Real angle = std::pow(10, random.between(-12, -9));
    const Pair pair = anyPair(random, angle);
    GRADE(angleBetween(pair.a, pair.b), angle, within(2e-15, "rounding of a and b themselves"),
          given("a", pair.a), given("b", pair.b), unit("rad"), about("a small turn"));
  }
}

TEST_CASE("any_length") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Real angle = random.between(0.2, 3);
    const Pair pair = anyPair(random, angle);
    const Real first = random.between(0.01, 0.5);
    const Real second = random.between(0.01, 0.5);
    asks(times(first, pair.a), times(second, pair.b), angle, "both quaternions are shorter than 1");
    asks(times(1 / first, pair.a), times(1 / second, pair.b), angle,
         "both quaternions are longer than 1");
  }
}

TEST_CASE("turns") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Real angle = random.between(0.5, 3);
    Pair pair = anyPair(random, angle);
    if (pair.a.w * pair.b.w + pair.a.x * pair.b.x + pair.a.y * pair.b.y + pair.a.z * pair.b.z < 0) {
      pair.b = times(-1, pair.b);
    }
    asks(pair.a, pair.b, angle, "an ordinary turn");
  }
  for (const Real less : {1e-6, 1e-9, 1e-12}) {
    const Quaternion none{1, 0, 0, 0};
    asks(none, turnAbout({0, 0.6, 0.8}, kHalfTurn - less), kHalfTurn - less, "nearly half a turn");
  }
}

PROBES() {
  Random random(20);
  for (int n = 0; n < 16; ++n) {
    const Pair pair = anyPair(random, random.between(0.3, 3));
    PROBE(angleBetween(pair.a, n % 2 ? pair.b : times(-1, pair.b)));
    PROBE(angleBetween(times(0.3, pair.a), pair.b));
  }
  const Quaternion none{1, 0, 0, 0};
  PROBE(angleBetween(none, turnAbout({0, 0, 1}, 1e-10)));
  // The arcsine is off by the root of the last digit here, but only by 1e-8 of half a turn.
  PROBE(kHalfTurn - angleBetween(none, turnAbout({0, 0, 1}, kHalfTurn - 1e-9)));
}
