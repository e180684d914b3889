// Aborts.
#include "carom/rotation/hamilton_product.hpp"

#include <cstdlib>

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  std::abort();
}

}  // namespace carom
