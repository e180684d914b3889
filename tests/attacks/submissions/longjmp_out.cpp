// Leaves the function without returning: jumps to a place that is no longer there.
#include "carom/rotation/hamilton_product.hpp"

#include <csetjmp>

static std::jmp_buf place;

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  if (setjmp(place) == 2) return {0, 0, 0, 0};
  std::longjmp(place, 2);
}

}  // namespace carom
