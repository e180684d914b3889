// Exercise 05.effective_mass: with how much mass do two bodies resist each other at their contact?
// Check it with: ./course check 05.effective_mass

#include "carom/impulse/effective_mass.hpp"

#include "carom/core/cross.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Real effectiveMass(const BodyMass& a, const BodyMass& b, const Contact& contact) {
  // Given: a contact that cannot be worked with is refused.
  requireUsable(contact);
  // Push the points apart with a unit impulse along contact.normal: how fast do they part then?
  // cross(a, b) is a x b, and a.dot(b) the inner product.
  return todo<Real>("effectiveMass");
}

}  // namespace carom
