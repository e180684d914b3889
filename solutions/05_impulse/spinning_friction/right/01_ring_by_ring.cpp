// Adds up the rings of the disc with Simpson's rule, which is exact for squares.
#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/impulse/spinning_friction.hpp"

namespace carom {

Real spinningFriction(const SpinningContact& contact) {
  const Real spin = contact.spin, inertia = contact.inertia, pressed = contact.normalImpulse;
  const Real mu = contact.friction, radius = contact.radius;
  if (!std::isfinite(spin) || !(inertia > 0) || !(pressed >= 0) || !(mu >= 0) || !(radius >= 0)) {
    throw InvalidInput("spinningFriction: no such contact");
  }
  if (radius == 0) return 0;
  // A ring at r carries 2 r / R^2 of the pressure for each metre of its width, and has the arm r.
  auto ring = [&](Real r) { return mu * pressed * 2 * r / (radius * radius) * r; };
  const Real disc = radius / 6 * (ring(0) + 4 * ring(radius / 2) + ring(radius));
  return std::clamp(-inertia * spin, -disc, disc);
}

}  // namespace carom
