// Asks the compiler to write its intermediate steps to a file, and to load a plugin.
#include "carom/rotation/hamilton_product.hpp"

#pragma GCC optimize("dump-tree-all=/tmp/carom_attack")
#pragma GCC plugin "/tmp/carom_attack.so"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
