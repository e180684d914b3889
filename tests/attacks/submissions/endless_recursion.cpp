// Calls itself for ever.
#include "carom/rotation/hamilton_product.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  volatile double here[64] = {q.w};
  const Quaternion next = hamiltonProduct(r, {here[0] + 1, q.x, q.y, q.z});
  return {next.w + here[0], here[1], here[2], here[3]};
}

}  // namespace carom
