// Throws before main begins.
#include "carom/rotation/hamilton_product.hpp"

static const int early = [] {
  throw 1;
  return 0;
}();

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {static_cast<double>(early), 0, 0, 0};
}

}  // namespace carom
