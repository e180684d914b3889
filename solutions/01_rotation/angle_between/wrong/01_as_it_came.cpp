#include "angle_between.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Real angleBetween(const Quaternion& a, const Quaternion& b) {
  const Real cosine = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  return 2 * std::acos(cosine);
}

}  // namespace carom
