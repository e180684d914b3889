#include "carom/solver/friction_pyramid_to_cone.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Vector2 frictionPyramidToCone(const Vector2& friction, const Vector2& slip, Real mass, Real limit) {
  requireNonNegative(mass, "mass");
  requireNonNegative(limit, "limit");
  const Vector2 wanted = friction - mass * slip;
  return {std::clamp(wanted.x(), -limit, limit), std::clamp(wanted.y(), -limit, limit)};
}

}  // namespace carom
