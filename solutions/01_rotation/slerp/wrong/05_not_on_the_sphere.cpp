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
  const Quaternion ua = renormalize(a), ub = renormalize(b);
  const Vector4 from(ua.w, ua.x, ua.y, ua.z);
  Vector4 to(ub.w, ub.x, ub.y, ub.z);
  if (from.dot(to) < 0) to = -to;
  const Vector4 q = (1 - t) * from + t * to;
  return {q(0), q(1), q(2), q(3)};
}

}  // namespace carom
