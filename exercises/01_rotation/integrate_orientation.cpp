// Exercise 01.integrate_orientation: the orientation after turning for a while.
// Check it with: ./course check 01.integrate_orientation

#include "carom/rotation/integrate_orientation.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Quaternion integrateOrientation(const Quaternion& q, const Vector3& angularVelocity, Real dt) {
  requireFinite(angularVelocity, "angularVelocity");
  requireFinite(dt, "dt");

  // Make the quaternion of the turn during dt, put it on the right side of q, and bring the
  // product to length 1.
  return todo<Quaternion>("integrateOrientation");
}

}  // namespace carom
