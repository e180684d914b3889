// q is brought to length 1 first.
#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "carom/rotation/scaled_quaternion.hpp"

namespace carom {

Vector3 rotatePoint(const Quaternion& q, const Vector3& v) {
  const Quaternion u = renormalize(q);
  const Quaternion right = hamiltonProduct({0, v.x(), v.y(), v.z()}, conjugate(u));
  const Quaternion turned = hamiltonProduct(u, right);
  return {turned.x, turned.y, turned.z};
}

}  // namespace carom
