// Exercise 05.sticking_impulse: friction and bounce at one corner, which somebody got wrong.
// Check it with: ./course check 05.sticking_impulse

#include "sticking_impulse.hpp"

#include "carom/core/errors.hpp"

namespace carom {

Vector2 stickingImpulse(const Matrix2& K, const Vector2& velocity, Real restitution) {
  const Real determinant = K(0, 0) * K(1, 1) - K(0, 1) * K(1, 0);
  if (!K.allFinite() || K(0, 1) != K(1, 0) || !(K(0, 0) > 0 && determinant > 0)) {
    throw InvalidInput("stickingImpulse: K must be symmetric and positive definite");
  }
  if (!velocity.allFinite()) throw InvalidInput("stickingImpulse: the velocity must be finite");
  if (!(restitution >= 0 && restitution <= 1)) {
    throw InvalidInput("stickingImpulse: restitution must be from 0 to 1");
  }
  // By how much the velocity of the corner has to change.
  const Vector2 change(-velocity.x(), -(1 + restitution) * velocity.y());
  const Real friction = change.x() / K(0, 0);
  const Real normal = change.y() / K(1, 1);
  return {friction, normal};
}

}  // namespace carom
