// Splits the way into a part along the motion and one across it.
#include "carom/toi/swept_balls.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/precision/double_double.hpp"

namespace carom {

TimeOfImpact sweptBalls(const MovingBall& a, const MovingBall& b, Real duration) {
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireNonNegative(duration, "duration");
  const Vector3 p = b.centre - a.centre, v = b.velocity - a.velocity;
  const Real R = a.radius + b.radius, speed = v.norm();
  DoubleDouble far = -exactProduct(R, R);
  for (int k = 0; k < 3; ++k) far = far + exactProduct(p[k], p[k]);

  TimeOfImpact hit;
  hit.status = ImpactStatus::kHit;
  if (far.value() < 0) return {.status = ImpactStatus::kOverlapping};
  if (far.value() > 0) {
    if (speed == 0) return {};
    const Real along = -p.dot(v) / speed, across = cross(p, v).norm() / speed;
    if (along <= 0 || across > R) return {};
    // (along - half chord) (along + half chord) = far
    const Real halfChord = std::sqrt((R - across) * (R + across));
    hit.time = far.value() / (along + halfChord) / speed;
    if (!(hit.time <= duration)) return {};
  }
  const Vector3 between = p + hit.time * v;
  hit.normal = between / between.norm();
  hit.point = b.centre + hit.time * b.velocity - b.radius * hit.normal;
  return hit;
}

}  // namespace carom
