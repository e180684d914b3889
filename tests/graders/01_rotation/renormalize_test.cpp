// Grader of 01.renormalize: quaternions made by stretching a unit quaternion, which must come back.

#include "carom/rotation/renormalize.hpp"

#include <cmath>

#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a square root, a division and a few roundings of squares";

Quaternion times(Real factor, const Quaternion& q) {
  return {factor * q.w, factor * q.x, factor * q.y, factor * q.z};
}

Real squaredLength(const Quaternion& q) {
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}

// Uniform on the sphere of unit quaternions, by throwing away what lies outside the ball.
Quaternion anyUnit(Random& random) {
  for (;;) {
    const Real w = random.between(-1, 1);
    const Vector3 v = random.vector();
    const Real squared = w * w + v.squaredNorm();
    if (squared > 0.01 && squared < 1) {
      return times(1 / std::sqrt(squared), {w, v.x(), v.y(), v.z()});
    }
  }
}

void asks(const Quaternion& q, const Quaternion& expected) {
  GRADE(renormalize(q), expected, within(6e-16, kRounding), given("q", q));
}

}  // namespace

TEST_CASE("length") {
  asks({3, 0, 4, 0}, {0.6, 0, 0.8, 0});
  asks({1, 2, -2, 4}, {0.2, 0.4, -0.4, 0.8});
  asks({-0.5, 0, 0, 0}, {-1, 0, 0, 0});
  asks({0, 0, 0, -7}, {0, 0, 0, -1});
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const Quaternion unit = anyUnit(random);
    asks(times(random.between(0.1, 5), unit), unit);
  }
}

TEST_CASE("drifted") {
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const Quaternion unit = anyUnit(random);
    const Quaternion q = times(1 + random.between(1e-6, 1e-3) * (n % 2 ? 1 : -1), unit);
    asks(q, unit);
    GRADE(squaredLength(renormalize(q)), 1, within(1e-15, kRounding), given("q", q),
          about("the square of the length of the result"));
  }
}

TEST_CASE("range") {
  for (const Real size : {1e200, 1e300, 1e-200, 1e-300}) {
    asks({3 * size, 0, -4 * size, 0}, {0.6, 0, -0.8, 0});
    asks({0, size, 0, 0}, {0, 1, 0, 0});
  }
}

TEST_CASE("refuses") {
  const Quaternion zero{0, 0, 0, 0};
  GRADE_REFUSES(renormalize(zero), given("q", zero));
}

PROBES() {
  Random random(16);
  for (int n = 0; n < 20; ++n) {
    const Quaternion unit = anyUnit(random);
    PROBE(renormalize(times(random.between(0.1, 3), unit)));
  }
  PROBE(renormalize({3e200, 0, -4e200, 0}));
  PROBE(renormalize({0, 3e-200, 0, -4e-200}));
  PROBE(renormalize({0, 0, 0, 0}));
}
