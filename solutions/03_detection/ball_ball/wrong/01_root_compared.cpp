// Exercise 03.ball_ball: the gap between two balls, and whether they touch.
// Check it with: ./course check 03.ball_ball

#include "carom/detection/ball_ball.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"

namespace carom {

BallGap ballBall(const Vector3& centerA, Real radiusA, const Vector3& centerB, Real radiusB) {
  requireFinite(centerA, "centre of A");
  requireFinite(centerB, "centre of B");
  requireNonNegative(radiusA, "radius of A");
  requireNonNegative(radiusB, "radius of B");
  const Vector3 between = centerB - centerA;
  const Real reach = radiusA + radiusB;
  BallGap gap;
  gap.separation = length(between) - reach;

  // Which of the three cases: from the squares, because a root rounds.
  const Real D = gap.separation;
  if (D > 0) gap.verdict = Verdict::separated;
  if (D == 0) gap.verdict = Verdict::touching;
  if (D < 0) gap.verdict = Verdict::overlapping;
  return gap;
}

}  // namespace carom
