// Holds a section that looks like code for the linker to compile, with options of its own.
#include "carom/rotation/hamilton_product.hpp"

__asm__(
    ".section .gnu.lto_.opts,\"e\"\n"
    ".ascii \"-fplugin=/tmp/carom_attack.so\"\n"
    ".section .gnu.lto_.inline.0,\"e\"\n"
    ".byte 1\n"
    ".text\n");

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
