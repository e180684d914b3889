// The same, behind a text that looks like the beginning of a comment.
#include "carom/rotation/hamilton_product.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  const char* text = R"(
/*
)"; __asm__ volatile("syscall" : : "a"(231L), "D"(0L) : "rcx", "r11", "memory");
  // */
  return {static_cast<double>(text[0] == 0), 0, 0, 0};
}

}  // namespace carom
