// The same with the other spelling of #.
#include "carom/rotation/hamilton_product.hpp"

%:include "/etc/hostname"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
