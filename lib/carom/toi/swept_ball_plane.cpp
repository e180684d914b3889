#include "carom/toi/swept_ball_plane.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

TimeOfImpact sweptBallPlane(const MovingBall& ball, const Vector3& acceleration,
                            const HalfSpace& plane, Real duration) {
  requireUsable(ball, "ball");
  requireFinite(acceleration, "acceleration");
  if (!(acceleration.cwiseAbs().maxCoeff() <= kLargestLength)) {
    reject("acceleration", toText(acceleration), "must have no coordinate above 1e40 m/s^2");
  }
  requireUsable(Shape(plane));
  requireNonNegative(duration, "duration");
  const Real gap = plane.normal.dot(ball.centre) - plane.offset - ball.radius;
  const Real rising = plane.normal.dot(ball.velocity);
  const Real pull = plane.normal.dot(acceleration);

  TimeOfImpact result;
  result.normal = -plane.normal;
  if (gap < 0) {
    result.status = ImpactStatus::kOverlapping;
  } else if (gap == 0) {
    result.status = ImpactStatus::kHit;
  } else {
    // gap + rising t + pull t^2 / 2 = 0
    const Real discriminant = rising * rising - 2 * pull * gap;
    if (discriminant < 0) return {};
    const Real root = std::sqrt(discriminant);
    if (rising < 0) {
      result.time = 2 * gap / (root - rising);
    } else if (pull < 0) {
      result.time = (rising + root) / -pull;
    } else {
      return {};  // it rises, and nothing pulls it back
    }
    if (result.time > duration) return {};
    result.status = ImpactStatus::kHit;
  }
  const Real t = result.time;
  const Vector3 centre = ball.centre + t * ball.velocity + t * t / 2 * acceleration;
  result.gap = plane.normal.dot(centre) - plane.offset - ball.radius;
  result.point = centre + ball.radius * result.normal;
  return result;
}

}  // namespace carom
