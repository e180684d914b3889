// The sign of (|d| - R)(|d| + R), from exact products where they are exact.
#include "carom/detection/ball_ball.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

BallGap ballBall(const Vector3& centerA, Real radiusA, const Vector3& centerB, Real radiusB) {
  requireFinite(centerA, "centre of A");
  requireFinite(centerB, "centre of B");
  requireNonNegative(radiusA, "radius of A");
  requireNonNegative(radiusB, "radius of B");
  const Real x = centerA.x() - centerB.x();
  const Real y = centerA.y() - centerB.y();
  const Real z = centerA.z() - centerB.z();
  const Real distance = std::hypot(x, y, z);
  const Real difference = x * x + y * y + z * z - (radiusA + radiusB) * (radiusA + radiusB);
  const Verdict verdict = difference > 0   ? Verdict::separated
                          : difference < 0 ? Verdict::overlapping
                                           : Verdict::touching;
  return {distance - radiusA - radiusB, verdict};
}

}  // namespace carom
