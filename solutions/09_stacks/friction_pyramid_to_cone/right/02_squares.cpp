#include "carom/solver/friction_pyramid_to_cone.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Vector2 frictionPyramidToCone(const Vector2& friction, const Vector2& slip, Real mass, Real limit) {
  requireNonNegative(mass, "mass");
  requireNonNegative(limit, "limit");
  const Real x = friction.x() - mass * slip.x();
  const Real y = friction.y() - mass * slip.y();
  const Real square = x * x + y * y;
  if (square <= limit * limit) return {x, y};
  const Real scale = limit / std::sqrt(square);
  return {scale * x, scale * y};
}

}  // namespace carom
