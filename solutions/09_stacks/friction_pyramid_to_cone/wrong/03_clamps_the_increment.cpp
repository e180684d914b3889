#include "carom/solver/friction_pyramid_to_cone.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Vector2 frictionPyramidToCone(const Vector2& friction, const Vector2& slip, Real mass, Real limit) {
  requireNonNegative(mass, "mass");
  requireNonNegative(limit, "limit");
  Vector2 more = -mass * slip;
  if (more.norm() > limit) more *= limit / more.norm();
  return friction + more;
}

}  // namespace carom
