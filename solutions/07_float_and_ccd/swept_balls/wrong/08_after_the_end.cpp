// Exercise 07.swept_balls: when do two balls meet that move in straight lines?
// Check it with: ./course check 07.swept_balls

#include "carom/toi/swept_balls.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/precision/double_double.hpp"

namespace carom {
namespace {

// Given: p.p - R^2 with all its digits, also when the balls nearly touch.
[[maybe_unused]] Real outside(const Vector3& p, Real R) {
  const DoubleDouble squared =
      exactProduct(p.x(), p.x()) + exactProduct(p.y(), p.y()) + exactProduct(p.z(), p.z());
  return (squared - exactProduct(R, R)).value();
}

}  // namespace

TimeOfImpact sweptBalls(const MovingBall& a, const MovingBall& b, Real duration) {
  // Given: what cannot be worked with is refused.
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireNonNegative(duration, "duration");
  TimeOfImpact result;  // no hit, until it is found
  const Vector3 p = b.centre - a.centre, v = b.velocity - a.velocity;
  const Real radii = a.radius + b.radius;
  const Real c = outside(p, radii), approach = -p.dot(v);
  if (c < 0) {
    result.status = ImpactStatus::kOverlapping;
    return result;
  }
  if (c > 0) {
    const Real root = v.squaredNorm() * radii * radii - cross(p, v).squaredNorm();
    if (approach <= 0 || root < 0) return result;
    result.time = c / (approach + std::sqrt(root));
  }
  result.status = ImpactStatus::kHit;
  result.normal = (p + result.time * v).normalized();
  result.point = a.centre + result.time * a.velocity + a.radius * result.normal;
  return result;
}

}  // namespace carom
