// Includes the test itself.
#include "carom/rotation/hamilton_product.hpp"

#include "../../graders/01_rotation/hamilton_product_test.cpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
