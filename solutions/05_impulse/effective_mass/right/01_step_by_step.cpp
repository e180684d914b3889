// As the words say it: push, and look how fast each point moves.
#include "carom/core/cross.hpp"
#include "carom/impulse/effective_mass.hpp"

namespace carom {

namespace {

// The speed along the normal that a unit impulse gives to the point at the end of the arm.
Real yielding(const BodyMass& body, const Vector3& arm, const Vector3& n) {
  const Vector3 linear = body.inverseMass * n;
  const Vector3 angular = body.inverseInertia * cross(arm, n);
  return n.dot(linear + cross(angular, arm));
}

}  // namespace

Real effectiveMass(const BodyMass& a, const BodyMass& b, const Contact& contact) {
  requireUsable(contact);
  return 1 /
         (yielding(a, contact.armA, contact.normal) + yielding(b, contact.armB, contact.normal));
}

}  // namespace carom
