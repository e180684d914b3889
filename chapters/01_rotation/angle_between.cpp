#include "angle_between.hpp"

#include <cmath>

#include "carom/core/elementary.hpp"
#include "carom/core/length.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/scaled_quaternion.hpp"

namespace carom {

//! [angle_between]
Real angleBetween(const Quaternion& a, const Quaternion& b) {
  const Quaternion turn =
      hamiltonProduct(conjugate(scaledQuaternion(a, "a")), scaledQuaternion(b, "b"));
  const Vector3 v(turn.x, turn.y, turn.z);
  return 2 * arctangent2(length(v), std::abs(turn.w));
}
//! [angle_between]

}  // namespace carom
