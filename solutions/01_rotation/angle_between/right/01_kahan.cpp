// Kahan's formula: difference and sum of the two unit quaternions.
#include "angle_between.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Real angleBetween(const Quaternion& a, const Quaternion& b) {
  const Quaternion p = renormalize(a), q = renormalize(b);
  const Vector4 u(p.w, p.x, p.y, p.z), v(q.w, q.x, q.y, q.z);
  const Real difference = (u - v).norm(), sum = (u + v).norm();
  return 4 * std::atan2(std::min(difference, sum), std::max(difference, sum));
}

}  // namespace carom
