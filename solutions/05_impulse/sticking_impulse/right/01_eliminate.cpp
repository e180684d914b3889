// Eliminates the friction first: what is left is one equation for the normal impulse.
#include "carom/core/errors.hpp"
#include "sticking_impulse.hpp"

namespace carom {

Vector2 stickingImpulse(const Matrix2& K, const Vector2& velocity, Real restitution) {
  const Real factor = K(1, 0) / K(0, 0);
  const Real rest = K(1, 1) - factor * K(0, 1);
  if (!K.allFinite() || K(0, 1) != K(1, 0) || !(K(0, 0) > 0) || !(rest > 0) ||
      !velocity.allFinite() || !(restitution >= 0) || !(restitution <= 1)) {
    throw InvalidInput("no such contact");
  }
  const Real bounce = -velocity.y() - restitution * velocity.y();
  const Real normal = (bounce + factor * velocity.x()) / rest;
  const Real friction = (-velocity.x() - K(0, 1) * normal) / K(0, 0);
  return {friction, normal};
}

}  // namespace carom
