// Exercise 03.ball_ball: the gap between two balls, and whether they touch.
// Check it with: ./course check 03.ball_ball

#include "carom/detection/ball_ball.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"
#include "carom/core/todo.hpp"

namespace carom {

BallGap ballBall(const Vector3& centerA, Real radiusA, const Vector3& centerB, Real radiusB) {
  // Given: what is no ball is refused.
  requireFinite(centerA, "centre of A");
  requireFinite(centerB, "centre of B");
  requireNonNegative(radiusA, "radius of A");
  requireNonNegative(radiusB, "radius of B");
  //# solution
  const Vector3 between = centerB - centerA;
  const Real reach = radiusA + radiusB;
  BallGap gap;
  gap.separation = length(between) - reach;

  // Which of the three cases: from the squares, because a root rounds.
  const Real squared = between.squaredNorm();
  if (squared > reach * reach) gap.verdict = Verdict::separated;
  if (squared == reach * reach) gap.verdict = Verdict::touching;
  if (squared < reach * reach) gap.verdict = Verdict::overlapping;
  return gap;
  //# stub
  // length(v) is |v|, v.squaredNorm() is |v|². The three verdicts are Verdict::separated,
  // Verdict::touching and Verdict::overlapping.
  //#| return todo<BallGap>("ballBall");
  //# end
}

}  // namespace carom
