// The same; the word is broken by the end of a line.
#include "carom/rotation/hamilton_product.hpp"

#inc\
lude "/etc/hostname"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
