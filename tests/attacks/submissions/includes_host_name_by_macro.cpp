// The same; the name is in a macro.
#include "carom/rotation/hamilton_product.hpp"

#define WHERE "/etc/hostname"
#include WHERE

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
