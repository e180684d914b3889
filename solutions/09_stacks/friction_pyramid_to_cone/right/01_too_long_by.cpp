#include "carom/solver/friction_pyramid_to_cone.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Vector2 frictionPyramidToCone(const Vector2& friction, const Vector2& slip, Real mass, Real limit) {
  requireNonNegative(mass, "mass");
  requireNonNegative(limit, "limit");
  Vector2 sum = friction;
  sum -= mass * slip;
  const Real tooLong = sum.norm() > 0 ? limit / sum.norm() : 1;
  return std::min(tooLong, Real(1)) * sum;
}

}  // namespace carom
