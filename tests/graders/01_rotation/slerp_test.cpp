// Grader of 01.slerp: turns about one axis in closed form, carried to any place by a product from the left
// and the right, which keeps all angles, and one published value with 25 digits.

#include "carom/rotation/slerp.hpp"

#include <cmath>

#include "carom/rotation/hamilton_product.hpp"
#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "some twenty roundings of numbers up to 1";

Quaternion minus(const Quaternion& q) {
  return {-q.w, -q.x, -q.y, -q.z};
}

Quaternion turnAbout(const Vector3& axis, Real angle) {
  const Vector3 u = std::sin(angle / 2) * axis;
  return {std::cos(angle / 2), u.x(), u.y(), u.z()};
}

Real squaredLength(const Quaternion& q) {
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}

void asks(const Quaternion& a, const Quaternion& b, Real t, const Quaternion& expected,
          const char* question) {
  GRADE(slerp(a, b, t), expected, within(4e-15, kRounding), given("a", a), given("b", b),
        given("t", t), upToSign(), about(question));
}

// Two orientations `angle` apart and what lies between them.
struct Pair {
  Vector3 axis;
  Quaternion a;
  Quaternion b;
  Quaternion at(Real fraction, Real angle) const {
    return hamiltonProduct(turnAbout(axis, fraction * angle), a);
  }
};
Pair anyPair(Random& random, Real angle) {
  Pair pair{random.direction(), turnAbout(random.direction(), random.between(0.5, 5)), {}};
  pair.b = hamiltonProduct(turnAbout(pair.axis, angle), pair.a);
  return pair;
}

}  // namespace

TEST_CASE("way") {
  const Real s = std::sin(1.45) * std::sqrt(0.5);
  const Quaternion a{std::cos(0.1), std::sin(0.1), 0, 0};
  const Quaternion b{std::cos(1.45), 0, s, s};
  asks(a, b, 0.3,
       {0.9027731715194977119610794, 0.08544531015274978477447402, 0.2980769193996139981688199,
        0.2980769193996139981688199},
       "three tenths of a turn of 2.9 rad");
  asks(a, b, 0, a, "the way begins at a");
  asks(a, b, 1, b, "the way ends at b");
  GRADE(squaredLength(slerp(a, b, 0.5)), 1, within(2e-15, kRounding), given("a", a), given("b", b),
        given("t", 0.5), about("the square of the length, half way"));
  asks({2, 0, 0, 0}, {0, 0, 0, 5}, 0.5, {std::sqrt(0.5), 0, 0, std::sqrt(0.5)},
       "half way between no turn and half a turn, of quaternions that are not of length 1");
}

TEST_CASE("speed") {
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const Real angle = random.between(1, 3);
    const Pair pair = anyPair(random, angle);
    const Real t = n % 3 == 0 ? random.between(1.1, 1.4) : random.between(0.1, 0.4);
    asks(pair.a, pair.b, t, pair.at(t, angle), "this fraction of a turn about one axis");
  }
}

TEST_CASE("short") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Real angle = random.between(0.5, 3);
    const Pair pair = anyPair(random, angle);
    const Real t = random.between(0.2, 0.8);
    asks(pair.a, minus(pair.b), t, pair.at(t, angle), "b is given with its other sign");
    asks(minus(pair.a), pair.b, t, pair.at(t, angle), "a is given with its other sign");
  }
}

TEST_CASE("close") {
  for (const Real angle : {1e-6, 1e-8, 1e-9, 1e-12}) {
    const Quaternion a{1, 0, 0, 0};
    const Quaternion b = turnAbout({0, 0.6, 0.8}, angle);
    GRADE(slerp(a, b, 0.25), turnAbout({0, 0.6, 0.8}, angle / 4), within(1e-15, kRounding),
          given("a", a), given("b", b), given("t", 0.25), upToSign(),
          about("a quarter of a very small turn"));
    // Next to 1 a tiny z hides in any tolerance, so it is asked for by itself as well.
    GRADE(slerp(a, b, 0.25).z / slerp(a, b, 1).z, 0.25, within(1e-6, "ratio of tiny numbers"),
          given("a", a), given("b", b), about("z after a quarter of the way / z at the end"));
  }
  Random random(seed());
  for (int n = 0; n < 5; ++n) {
    const Quaternion a = turnAbout(random.direction(), random.between(0.5, 5));
    asks(a, a, 0.5, a, "a and b are the same");
    asks(a, minus(a), 0.3, a, "a and b are the same, with other signs");
  }
}

PROBES() {
  Random random(19);
  for (int n = 0; n < 16; ++n) {
    const Pair pair = anyPair(random, random.between(0.5, 3));
    PROBE(slerp(pair.a, n % 2 ? pair.b : minus(pair.b), random.between(0, 1)));
  }
  const Quaternion one{1, 0, 0, 0};
  PROBE(slerp(one, one, 0.5));
  PROBE(slerp(one, turnAbout({0, 0, 1}, 2e-9), 0.5).z);
}
