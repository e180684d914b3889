#include "angle_between.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Real angleBetween(const Quaternion& a, const Quaternion& b) {
  const Quaternion turn = hamiltonProduct(conjugate(renormalize(a)), renormalize(b));
  return 2 * std::acos(std::min(1.0, std::abs(turn.w)));
}

}  // namespace carom
