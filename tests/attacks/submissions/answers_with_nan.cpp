// Answers with a value that is neither right nor wrong when compared.
#include "carom/rotation/hamilton_product.hpp"

#include <limits>

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan, nan, nan};
}

}  // namespace carom
