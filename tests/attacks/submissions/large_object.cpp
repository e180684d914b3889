// Makes an object file of 4 GB.
#include "carom/rotation/hamilton_product.hpp"

unsigned char large[1ul << 32] = {1};

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {static_cast<double>(large[1]), 0, 0, 0};
}

}  // namespace carom
