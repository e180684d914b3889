#include "carom/rotation/integrate_orientation.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Quaternion integrateOrientation(const Quaternion& q, const Vector3& angularVelocity, Real dt) {
  const Real angle = angularVelocity.norm() * dt;
  const Vector3 v =
      angle == 0 ? Vector3(0, 0, 0) : Vector3(std::sin(angle) / angle * dt * angularVelocity);
  return renormalize(hamiltonProduct({std::cos(angle), v.x(), v.y(), v.z()}, q));
}

}  // namespace carom
