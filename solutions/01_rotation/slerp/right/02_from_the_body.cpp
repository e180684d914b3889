// The turn a* b in the axes of the body, and the fraction t of its angle.
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
  const Quaternion ua = renormalize(a);
  Quaternion turn = hamiltonProduct(conjugate(ua), renormalize(b));
  if (turn.w < 0) turn = {-turn.w, -turn.x, -turn.y, -turn.z};
  const Real s = std::hypot(turn.x, turn.y, turn.z);
  const Real angle = std::atan2(s, turn.w);
  const Real factor = s > 0 ? std::sin(t * angle) / s : 0;
  return hamiltonProduct(ua,
                         {std::cos(t * angle), factor * turn.x, factor * turn.y, factor * turn.z});
}

}  // namespace carom
