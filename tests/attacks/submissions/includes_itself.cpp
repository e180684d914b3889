// Includes itself twice, and so on.
#include "carom/rotation/hamilton_product.hpp"

#include "includes_itself.cpp"
#include "includes_itself.cpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
