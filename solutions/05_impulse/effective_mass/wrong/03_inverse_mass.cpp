// Exercise 05.effective_mass: with how much mass do two bodies resist each other at their contact?
// Check it with: ./course check 05.effective_mass

#include "carom/impulse/effective_mass.hpp"

#include "carom/core/cross.hpp"

namespace carom {

Real effectiveMass(const BodyMass& a, const BodyMass& b, const Contact& contact) {
  // Given: a contact that cannot be worked with is refused.
  requireUsable(contact);
  const Vector3 torqueA = cross(contact.armA, contact.normal);
  const Vector3 torqueB = cross(contact.armB, contact.normal);
  const Real pushing = a.inverseMass + b.inverseMass;
  const Real turning =
      torqueA.dot(a.inverseInertia * torqueA) + torqueB.dot(b.inverseInertia * torqueB);
  return pushing + turning;
}

}  // namespace carom
