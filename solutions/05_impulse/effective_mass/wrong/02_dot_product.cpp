// Exercise 05.effective_mass: with how much mass do two bodies resist each other at their contact?
// Check it with: ./course check 05.effective_mass

#include "carom/impulse/effective_mass.hpp"

#include "carom/core/cross.hpp"

namespace carom {

Real effectiveMass(const BodyMass& a, const BodyMass& b, const Contact& contact) {
  // Given: a contact that cannot be worked with is refused.
  requireUsable(contact);
  const Vector3& n = contact.normal;
  const Real alongA = contact.armA.dot(n);
  const Real alongB = contact.armB.dot(n);
  const Real pushing = a.inverseMass + b.inverseMass;
  const Real turning =
      alongA * alongA * n.dot(a.inverseInertia * n) + alongB * alongB * n.dot(b.inverseInertia * n);
  return 1 / (pushing + turning);
}

}  // namespace carom
