#include "carom/impulse/effective_mass.hpp"

#include "carom/core/cross.hpp"

namespace carom {

Real effectiveMass(const BodyMass& a, const BodyMass& b, const Contact& contact) {
  requireUsable(contact);
  // The torque of a unit impulse. Moving the arm across the product turns n . (w x r) into
  // (r x n) . w, which needs one cross product less and is never negative.
  const Vector3 torqueA = cross(contact.armA, contact.normal);
  const Vector3 torqueB = cross(contact.armB, contact.normal);
  const Real turning =
      torqueA.dot(a.inverseInertia * torqueA) + torqueB.dot(b.inverseInertia * torqueB);
  return 1 / (a.inverseMass + b.inverseMass + turning);
}

}  // namespace carom
