// Exercise 07.swept_ball_plane: when does a thrown ball touch a floor?
// Check it with: ./course check 07.swept_ball_plane

#include "carom/toi/swept_ball_plane.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

TimeOfImpact sweptBallPlane(const MovingBall& ball, const Vector3& acceleration,
                            const HalfSpace& plane, Real duration) {
  // Given: what cannot be worked with is refused.
  requireUsable(ball, "ball");
  requireFinite(acceleration, "acceleration");
  requireUsable(Shape(plane));
  requireNonNegative(duration, "duration");
  TimeOfImpact result;  // no hit, until it is found
  const Real height = plane.normal.dot(ball.centre) - plane.offset - ball.radius;
  const Real rising = plane.normal.dot(ball.velocity), pull = plane.normal.dot(acceleration);
  if (height < 0) {
    result.status = ImpactStatus::kOverlapping;
    return result;
  }
  if (height > 0) {
    const Real under = rising * rising - 4 * pull * height;
    if (under < 0) return result;
    const Real root = std::sqrt(under);
    if (rising < 0) {
      result.time = 2 * height / (root - rising);
    } else if (pull < 0) {
      result.time = (rising + root) / (-2 * pull);
    } else {
      return result;
    }
    if (result.time > duration) return {};
  }
  result.status = ImpactStatus::kHit;
  result.normal = -plane.normal;
  const Real t = result.time;
  result.point = ball.centre + t * ball.velocity + t * t / 2 * acceleration;
  result.point += ball.radius * result.normal;
  return result;
}

}  // namespace carom
