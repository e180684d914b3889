// Asks for 2 GiB.
#include "carom/rotation/hamilton_product.hpp"

#include <vector>

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  std::vector<char> much(std::size_t{2} << 30, 'x');
  return {static_cast<double>(much[much.size() / 2]), 0, 0, 0};
}

}  // namespace carom
