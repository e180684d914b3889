// Says that it is another file, so that the compiler quotes a line of that in its message.
#include "carom/rotation/hamilton_product.hpp"

#line 1 "/etc/passwd"
int taken = whatIsInTheFirstLine;

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
