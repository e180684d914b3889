#include "carom/detection/ball_ball.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/gap_sign.hpp"

namespace carom {

BallGap ballBall(const Vector3& centerA, Real radiusA, const Vector3& centerB, Real radiusB) {
  requireFinite(centerA, "centre of A");
  requireFinite(centerB, "centre of B");
  requireNonNegative(radiusA, "radius of A");
  requireNonNegative(radiusB, "radius of B");

  // D = |d| - r_a - r_b; length() and not sqrt(d · d), whose squares overflow at 1e154.
  BallGap gap;
  gap.separation = length(centerB - centerA) - (radiusA + radiusB);

  // Which of the three cases: without the root, and without rounding.
  const int sign = gapSign(centerA, radiusA, centerB, radiusB);
  if (sign > 0) gap.verdict = Verdict::separated;
  if (sign == 0) gap.verdict = Verdict::touching;
  if (sign < 0) gap.verdict = Verdict::overlapping;
  return gap;
}

}  // namespace carom
