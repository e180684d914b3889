// Exercise 05.apply_impulse: what does an impulse do to the two bodies it acts between?
// Check it with: ./course check 05.apply_impulse

#include "carom/impulse/apply_impulse.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/todo.hpp"

namespace carom {

void applyImpulse(OrientedBody& a, const Vector3& armA, OrientedBody& b, const Vector3& armB,
                  const Vector3& impulse) {
  // Given: what is no number is refused, before anything has changed.
  requireFinite(armA, "armA");
  requireFinite(armB, "armB");
  requireFinite(impulse, "impulse");
  // R_WB takes the body's axes to the world's, and R_WB.transpose() the world's to the body's.
  todo<int>("applyImpulse");
}

}  // namespace carom
