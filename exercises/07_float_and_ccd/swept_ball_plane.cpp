// Exercise 07.swept_ball_plane: when does a thrown ball touch a floor?
// Check it with: ./course check 07.swept_ball_plane

#include "carom/toi/swept_ball_plane.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

TimeOfImpact sweptBallPlane(const MovingBall& ball, const Vector3& acceleration,
                            const HalfSpace& plane, Real duration) {
  // Given: what cannot be worked with is refused.
  requireUsable(ball, "ball");
  requireFinite(acceleration, "acceleration");
  requireUsable(Shape(plane));
  requireNonNegative(duration, "duration");
  TimeOfImpact result;  // no hit, until it is found
  // plane.normal.dot(x) is how far x goes in the direction of the normal. A status is, for example,
  // ImpactStatus::kHit.
  return todo<TimeOfImpact>("sweptBallPlane");
}

}  // namespace carom
