#include "carom/rotation/integrate_orientation.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Quaternion integrateOrientation(const Quaternion& q, const Vector3& angularVelocity, Real dt) {
  return hamiltonProduct(quaternionExponential(angularVelocity * dt), q);
}

}  // namespace carom
