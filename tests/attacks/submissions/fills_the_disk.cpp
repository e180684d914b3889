// Writes a large file.
#include "carom/rotation/hamilton_product.hpp"

#include <cstdio>

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  static const char block[1 << 16] = {};
  if (std::FILE* file = std::fopen("/tmp/carom_attack_large", "w")) {
    for (int i = 0; i < 1024; ++i) std::fwrite(block, 1, sizeof block, file);
    std::fclose(file);
    std::remove("/tmp/carom_attack_large");
  }
  return {0, 0, 0, 0};
}

}  // namespace carom
