// Axis and angle, and the product written out.
#include "carom/rotation/integrate_orientation.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Quaternion integrateOrientation(const Quaternion& q, const Vector3& angularVelocity, Real dt) {
  const Real rate = angularVelocity.norm();
  const Vector3 axis = rate > 0 ? Vector3(angularVelocity / rate) : Vector3(1, 0, 0);
  const Real c = std::cos(rate * dt / 2), s = std::sin(rate * dt / 2);
  const Vector3 u(q.x, q.y, q.z);
  const Vector3 v = c * u + s * (q.w * axis + cross(axis, u));
  return renormalize({c * q.w - s * axis.dot(u), v.x(), v.y(), v.z()});
}

}  // namespace carom
