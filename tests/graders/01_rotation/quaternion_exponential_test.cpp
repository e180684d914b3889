// Grader of 01.quaternion_exponential: turns whose quaternion is plain, the law exp(v) exp(v) = exp(2v),
// whose right side is known, a turn of 130 rad with 25 digits, and turns so small that v/2 is exact.

#include "carom/rotation/quaternion_exponential.hpp"

#include <cmath>

#include "carom/rotation/hamilton_product.hpp"
#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kHalfTurn = 3.14159265358979323846;  // [rad]
constexpr const char* kRounding = "a handful of roundings of numbers up to 1";

// The product of q with itself: the turn twice.
Quaternion square(const Quaternion& q) {
  return hamiltonProduct(q, q);
}

Vector3 vectorPart(const Quaternion& q) {
  return {q.x, q.y, q.z};
}

void asks(const Vector3& v, const Quaternion& expected) {
  GRADE(quaternionExponential(v), expected, within(1e-15, kRounding),
        given("rotationVector", v, "rad"));
}

}  // namespace

TEST_CASE("turns") {
  asks({0, kHalfTurn, 0}, {0, 0, 1, 0});
  asks({0, 0, -kHalfTurn / 3}, {std::sqrt(0.75), 0, 0, -0.5});
  const Real third = 2 * kHalfTurn / 3 / std::sqrt(3.0);
  asks({third, third, third}, {0.5, 0.5, 0.5, 0.5});
  const Vector3 v(30, -40, 120);
  GRADE(quaternionExponential(v),
        (Quaternion{-0.5624538512381720310621218, 0.1908066183438700310100491,
                    -0.2544088244584933746800654, 0.7632264733754801240401963}),
        within(1.5e-14, "the angle 130 rad is rounded, which is 1.4e-14 rad"),
        given("rotationVector", v, "rad"));
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const Vector3 axis = random.direction();
    const Real angle = random.between(0.1, 6);
    const Vector3 u = std::sin(angle) * axis;
    const Vector3 rotation = angle * axis;
    GRADE(square(quaternionExponential(rotation)),
          (Quaternion{std::cos(angle), u.x(), u.y(), u.z()}), within(4e-15, kRounding),
          given("rotationVector", rotation, "rad"),
          about("q q is the turn by twice the angle, so it holds the whole angle"));
  }
}

TEST_CASE("zero") {
  asks({0, 0, 0}, {1, 0, 0, 0});
  // sin(a/2)/a times a, with the first two terms of the series: what is left out is below 1e-20.
  const Real a = 1e-4;
  const Real x = a / 2 - a * a * a / 48;
  GRADE(quaternionExponential(Vector3(a, 0, 0)).x, x, withinRelative(1e-15, kRounding),
        given("rotationVector", Vector3(a, 0, 0), "rad"), about("x of the answer"));
}

TEST_CASE("small") {
  for (const Real a : {1e-7, 1e-8, 1e-12, 1e-16, 1e-100}) {
    const Vector3 v(2 * a, -a, 2 * a);
    const Vector3 half = v / 2;
    GRADE(vectorPart(quaternionExponential(v)), half,
          withinRelative(1e-13, "what v/2 leaves out is below (3e-7)^2 / 24 of it"),
          given("rotationVector", v, "rad"), about("x, y and z of the answer"));
  }
}

PROBES() {
  Random random(17);
  for (int n = 0; n < 16; ++n) PROBE(quaternionExponential(random.vector(3)));
  PROBE(quaternionExponential(Vector3(0, 0, 0)));
  PROBE(quaternionExponential(Vector3(1e-3, 2e-3, 0)));
  PROBE(vectorPart(quaternionExponential(Vector3(1e-7, 2e-7, 0))));
  PROBE(vectorPart(quaternionExponential(Vector3(0, 2e-12, -1e-12))));
}
