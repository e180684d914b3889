// The fraction t of the rotation vector of the turn from a to b.
#include "carom/rotation/slerp.hpp"

#include <algorithm>
#include <cmath>

#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Quaternion slerp(const Quaternion& a, const Quaternion& b, Real t) {
  const Vector3 v = quaternionLogarithm(hamiltonProduct(b, conjugate(a)));
  return renormalize(hamiltonProduct(quaternionExponential(t * v), a));
}

}  // namespace carom
