// Grader of 01.integrate_orientation: a constant turn in closed form, quarter turns whose products are
// plain, and the fact that time adds up: many short steps lead where a long one leads.

#include "carom/rotation/integrate_orientation.hpp"

#include <cmath>

#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kQuarter = 1.57079632679489661923;  // [rad]
const Real h = std::sqrt(0.5);
const Quaternion none{1, 0, 0, 0};
const Quaternion quarterX{h, h, 0, 0};
const Quaternion quarterY{h, 0, h, 0};
constexpr const char* kRounding = "a handful of roundings of numbers up to 1";

void asks(const Quaternion& q, const Vector3& omega, Real dt, const Quaternion& expected,
          const char* question = "the orientation after this time") {
  GRADE(integrateOrientation(q, omega, dt), expected, within(2e-15, kRounding), given("q", q),
        given("angularVelocity", omega, "rad/s"), given("dt", dt, "s"), upToSign(),
        about(question));
}

// The same time in steps.
Quaternion inSteps(Quaternion q, const Vector3& omega, Real time, int steps) {
  for (int i = 0; i < steps; ++i) q = integrateOrientation(q, omega, time / steps);
  return q;
}

Real squaredLength(const Quaternion& q) {
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}

}  // namespace

TEST_CASE("constant") {
  const Vector3 omega(3, -4, 12);
  GRADE(integrateOrientation(none, omega, 10),
        (Quaternion{-0.5624538512381720310621218, 0.1908066183438700310100491,
                    -0.2544088244584933746800654, 0.7632264733754801240401963}),
        within(1.5e-14, "the angle 130 rad is rounded, which is 1.4e-14 rad"), given("q", none),
        given("angularVelocity", omega, "rad/s"), given("dt", 10.0, "s"), upToSign());
  asks(none, {0, 0, kQuarter}, 1, {h, 0, 0, h});
  asks(none, {0, kQuarter, 0}, -1, {h, 0, -h, 0}, "a negative time turns back");
  asks(quarterX, {1, 0, 0}, 2 * kQuarter, {-h, h, 0, 0});
}

TEST_CASE("frame") {
  asks(quarterX, {0, 0, kQuarter}, 1, {0.5, 0.5, 0.5, 0.5},
       "a quarter turn about x has been made, now comes one about z of the world");
  asks(quarterY, {kQuarter, 0, 0}, 1, {0.5, 0.5, 0.5, 0.5},
       "a quarter turn about y has been made, now comes one about x of the world");
  asks(quarterY, {0, 0, -kQuarter}, 1, {0.5, 0.5, 0.5, -0.5},
       "a quarter turn about y has been made, now comes one back about z of the world");
}

TEST_CASE("steps") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Vector3 axis = random.direction();
    const Real rate = random.between(1, 4);
    const Real time = random.between(0.5, 1.5);
    const Vector3 omega = rate * axis;
    const Vector3 u = std::sin(rate * time / 2) * axis;
    const int steps = random.integer(1, 12);
    GRADE(inSteps(none, omega, time, steps),
          (Quaternion{std::cos(rate * time / 2), u.x(), u.y(), u.z()}), within(1e-14, kRounding),
          given("angularVelocity", omega, "rad/s"), given("time", time, "s"), given("steps", steps),
          upToSign(), about("a constant turn, made in steps"));
  }
}

TEST_CASE("unit") {
  asks({3, 0, 0, 0}, {0, kQuarter, 0}, 1, {h, 0, h, 0}, "the quaternion at the start has length 3");
  asks({0, 0, 0, 0.01}, {0, 0, kQuarter}, 1, {-h, 0, 0, h},
       "the quaternion at the start has length 0.01");
  Random random(seed());
  for (int n = 0; n < 10; ++n) {
    const Vector3 u = random.vector();
    const Quaternion q{random.between(0.5, 1), u.x(), u.y(), u.z()};
    const Vector3 omega = random.vector(5);
    GRADE(squaredLength(integrateOrientation(q, omega, 0.1)), 1, within(1e-15, kRounding),
          given("q", q), given("angularVelocity", omega, "rad/s"), given("dt", 0.1, "s"),
          about("the square of the length of the result"));
  }
}

PROBES() {
  Random random(18);
  for (int n = 0; n < 20; ++n) {
    const Vector3 u = random.vector();
    const Vector3 omega = random.vector(4);
    const Quaternion q{random.between(0.5, 1), u.x(), u.y(), u.z()};
    PROBE(integrateOrientation(q, omega, random.between(-1, 1)));
  }
}
