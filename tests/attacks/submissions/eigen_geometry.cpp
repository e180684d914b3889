// Lets Eigen's quaternions multiply.
#include "carom/rotation/hamilton_product.hpp"

#include <Eigen/Geometry>

namespace carom {

Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  const Eigen::Quaterniond product =
      Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Eigen::Quaterniond(r.w, r.x, r.y, r.z);
  return {product.w(), product.x(), product.y(), product.z()};
}

}  // namespace carom
