#include "carom/rotation/integrate_orientation.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Quaternion integrateOrientation(const Quaternion& q, const Vector3& angularVelocity, Real dt) {
  const Vector3 w = angularVelocity * dt / 2;
  const Quaternion d = hamiltonProduct({0, w.x(), w.y(), w.z()}, q);
  return {q.w + d.w, q.x + d.x, q.y + d.y, q.z + d.z};
}

}  // namespace carom
