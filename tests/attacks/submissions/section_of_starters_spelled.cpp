// Puts a pointer among those that are called before main, in the other spelling.
#include "carom/rotation/hamilton_product.hpp"

static void early() {
  __builtin_trap();
}
[[gnu::section(".init_array"), gnu::used]] static void (*const start)() = early;

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
