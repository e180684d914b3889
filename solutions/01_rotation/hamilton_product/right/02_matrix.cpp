// The left factor as a 4 x 4 matrix.
#include "carom/rotation/hamilton_product.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  Eigen::Matrix<Real, 4, 4> left;
  left << q.w, -q.x, -q.y, -q.z,  //
      q.x, q.w, -q.z, q.y,        //
      q.y, q.z, q.w, -q.x,        //
      q.z, -q.y, q.x, q.w;
  const Vector4 product = left * Vector4(r.w, r.x, r.y, r.z);
  return {product(0), product(1), product(2), product(3)};
}

}  // namespace carom
