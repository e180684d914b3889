#include "carom/impulse/bounded_impact.hpp"

#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/coulomb_impact.hpp"
#include "carom/impulse/passive_impact.hpp"

namespace carom {

Impact boundedImpact(const MovingBody& a, const MovingBody& b, const Contact& contact,
                     const ImpactLaw& law) {
  const Impact impact = coulombImpact(a, b, contact, law);
  MovingBody afterA = a, afterB = b;
  changeVelocities(afterA, afterB, contact, impact.impulse);
  // An impulse does its work at the mean of the velocities before and after.
  const Vector3 twiceMean =
      relativeVelocity(a, b, contact) + relativeVelocity(afterA, afterB, contact);
  if (impact.impulse.dot(twiceMean) <= 0) return impact;
  return passiveImpact(a, b, contact, {law.restitution, law.friction, 0});
}

}  // namespace carom
