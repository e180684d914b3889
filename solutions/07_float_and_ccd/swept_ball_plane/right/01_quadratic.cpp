// Leaves the roots to stableQuadratic, and takes the first that is ahead.
#include "carom/toi/swept_ball_plane.hpp"

#include "carom/core/checks.hpp"
#include "carom/precision/stable_quadratic.hpp"

namespace carom {

TimeOfImpact sweptBallPlane(const MovingBall& ball, const Vector3& acceleration,
                            const HalfSpace& plane, Real duration) {
  requireUsable(ball, "ball");
  requireFinite(acceleration, "acceleration");
  requireUsable(Shape(plane));
  requireNonNegative(duration, "duration");
  const Real height = plane.normal.dot(ball.centre) - (plane.offset + ball.radius);
  TimeOfImpact hit;
  hit.status = ImpactStatus::kHit;
  hit.normal = -1 * plane.normal;
  if (height < 0) return {.status = ImpactStatus::kOverlapping};
  if (height > 0) {
    const QuadraticRoots roots = stableQuadratic(plane.normal.dot(acceleration) / 2,
                                                 plane.normal.dot(ball.velocity), height);
    if (roots.count == RootCount::none || roots.second <= 0) return {};
    hit.time = roots.first > 0 ? roots.first : roots.second;
    if (hit.time > duration) return {};
  }
  const Vector3 centre = ball.centre + hit.time * (ball.velocity + hit.time * acceleration / 2);
  hit.point = centre - ball.radius * plane.normal;
  return hit;
}

}  // namespace carom
