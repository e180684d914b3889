// Exercise 01.angle_between: how far apart are two orientations?
// Check it with: ./course check 01.angle_between

#include "angle_between.hpp"

#include <cmath>

#include "carom/core/elementary.hpp"
#include "carom/core/length.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/scaled_quaternion.hpp"

namespace carom {

Real angleBetween(const Quaternion& a, const Quaternion& b) {
  scaledQuaternion(a, "a");  // refuses zero and not-a-number
  scaledQuaternion(b, "b");

  const Real cosine = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  return 2 * std::acos(cosine);
}

}  // namespace carom
