#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "carom/rotation/scaled_quaternion.hpp"

namespace carom {

Vector3 rotatePoint(const Quaternion& q, const Vector3& v) {
  const Quaternion point{0, v.x(), v.y(), v.z()};
  const Quaternion turned = hamiltonProduct(hamiltonProduct(q, point), conjugate(q));
  return Vector3(turned.x, turned.y, turned.z) / squaredNorm(q);
}

}  // namespace carom
