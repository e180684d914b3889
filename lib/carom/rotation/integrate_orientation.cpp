#include "carom/rotation/integrate_orientation.hpp"

#include "carom/core/checks.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Quaternion integrateOrientation(const Quaternion& q, const Vector3& angularVelocity, Real dt) {
  requireFinite(angularVelocity, "angularVelocity");
  requireFinite(dt, "dt");
  const Quaternion turn = quaternionExponential(angularVelocity * dt);
  return renormalize(hamiltonProduct(turn, q));
}

}  // namespace carom
