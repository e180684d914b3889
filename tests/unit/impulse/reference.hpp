#pragma once
// What the tests of the impulse layer share: reference values from tests/cases/impulse.json,
// bodies, and what an impact must keep.

#include <algorithm>
#include <cmath>
#include <string>

#include "carom/core/cross.hpp"
#include "carom/core/random.hpp"
#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"
#include "support/cases.hpp"

namespace carom_test {

constexpr double kUlp = 2.220446049250313e-16;

// One case of group I.
inline json impulseCase(const std::string& id) {
  return readCase("impulse", id);
}

inline carom::Vector2 vector2(const json& value) {
  return {number(value.at(0)), number(value.at(1))};
}

// Within so many units in the last place of the larger of both.
inline bool near(double got, double expected, double ulps = 2) {
  return std::abs(got - expected) <= ulps * kUlp * std::max(std::abs(got), std::abs(expected));
}

// Within a share of the length expected.
template <class V>
bool nearVector(const V& got, const V& expected, double share = 1e-15) {
  return (got - expected).norm() <= share * expected.norm();
}

// A rotation matrix with random axes.
inline carom::Matrix3 randomRotation(carom::Random& random) {
  const carom::Vector3 x = random.direction();
  const carom::Vector3 y = carom::cross(random.direction(), x).normalized();
  carom::Matrix3 R;
  R.col(0) = x;
  R.col(1) = y;
  R.col(2) = carom::cross(x, y);
  return R;
}

// Moments that a solid can have: none is larger than the sum of the other two.
inline carom::Vector3 randomMoments(carom::Random& random, double mass, double size) {
  const carom::Vector3 spread =
      mass * size * size *
      carom::Vector3(random.between(0.01, 1), random.between(0.01, 1), random.between(0.01, 1));
  return {spread.y() + spread.z(), spread.x() + spread.z(), spread.x() + spread.y()};
}

}  // namespace carom_test
