#include "carom/impulse/gears.hpp"

#include "carom/core/checks.hpp"

namespace carom {

Real meshedInertia(Real inertia1, int teeth1, Real inertia2, int teeth2) {
  requirePositive(inertia1, "inertia1");
  requirePositive(inertia2, "inertia2");
  requirePositive(teeth1, "teeth1");
  requirePositive(teeth2, "teeth2");
  const Real ratio = Real(teeth1) / teeth2;
  return inertia1 + inertia2 * ratio * ratio;
}

Real meshGears(Gear& first, Gear& second) {
  for (const Gear* gear : {&first, &second}) {
    requirePositive(gear->inertia, "inertia");
    requirePositive(gear->radius, "radius");
    requireFinite(gear->angularVelocity, "angularVelocity");
  }
  // Where they meet one rim goes up and the other down if both turn the same way round.
  const Real slip = first.angularVelocity * first.radius + second.angularVelocity * second.radius;
  const Real inverseMass =
      first.radius * first.radius / first.inertia + second.radius * second.radius / second.inertia;
  const Real impulse = -slip / inverseMass;
  first.angularVelocity += impulse * first.radius / first.inertia;
  second.angularVelocity += impulse * second.radius / second.inertia;
  return impulse;
}

}  // namespace carom
