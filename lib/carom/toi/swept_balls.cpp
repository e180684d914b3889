#include "carom/toi/swept_balls.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/exact_number.hpp"
#include "carom/precision/double_double.hpp"

namespace carom {
namespace {

// a R^2 - |p x v|^2 in any arithmetic: a ball or doubles with more digits.
template <class Number>
Number discriminant(const Vector3& p, const Vector3& v, Real radii) {
  const auto product = [](Real x, Real y) { return Number(x) * Number(y); };
  const auto square = [](const Number& x) { return x * x; };
  const Number speed2 = product(v.x(), v.x()) + product(v.y(), v.y()) + product(v.z(), v.z());
  return speed2 * product(radii, radii) - (square(product(p.y(), v.z()) - product(p.z(), v.y())) +
                                           square(product(p.z(), v.x()) - product(p.x(), v.z())) +
                                           square(product(p.x(), v.y()) - product(p.y(), v.x())));
}

// The sign of the discriminant, exactly, and its value to the digits of a double.
Real certainDiscriminant(const Vector3& p, const Vector3& v, Real radii) {
  const Real value = discriminant<DoubleDouble>(p, v, radii).value();
  const Real size = v.squaredNorm() * (radii * radii + p.squaredNorm());
  if (std::abs(value) > 0x1p-90 * size) return value;
  return discriminant<ExactNumber>(p, v, radii).value();
}

}  // namespace

TimeOfImpact sweptBalls(const MovingBall& a, const MovingBall& b, Real duration) {
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireNonNegative(duration, "duration");
  const Vector3 p = b.centre - a.centre, v = b.velocity - a.velocity;
  const Real radii = a.radius + b.radius;

  // How far outside the start is: p.p - R^2, without losing its digits near contact.
  const DoubleDouble outside = exactProduct(p.x(), p.x()) + exactProduct(p.y(), p.y()) +
                               exactProduct(p.z(), p.z()) - exactProduct(radii, radii);
  TimeOfImpact result;
  const Real approach = -p.dot(v);
  if (outside.value() < 0) {
    result.status = ImpactStatus::kOverlapping;
  } else if (outside.value() == 0) {
    result.status = ImpactStatus::kHit;
  } else if (approach > 0) {
    const Real root = certainDiscriminant(p, v, radii);
    if (root < 0) return result;
    result.time = outside.value() / (approach + std::sqrt(root));
    if (result.time > duration) return {};
    result.status = ImpactStatus::kHit;
  } else {
    return result;
  }
  const Vector3 between = p + result.time * v;
  const Real distance = length(between);
  if (distance > 0) result.normal = between / distance;
  result.gap = distance - radii;
  result.point = a.centre + result.time * a.velocity + a.radius * result.normal;
  return result;
}

}  // namespace carom
