// Scalar and vector part: {w w' - a.a', w a' + w' a + a x a'}.
#include "carom/core/cross.hpp"
#include "carom/rotation/hamilton_product.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  const Vector3 a(q.x, q.y, q.z);
  const Vector3 b(r.x, r.y, r.z);
  const Vector3 v = q.w * b + r.w * a + cross(a, b);
  return {q.w * r.w - a.dot(b), v.x(), v.y(), v.z()};
}

}  // namespace carom
