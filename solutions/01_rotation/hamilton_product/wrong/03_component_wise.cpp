#include "carom/rotation/hamilton_product.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  return {q.w * r.w, q.x * r.x, q.y * r.y, q.z * r.z};
}

}  // namespace carom
