// Sends bytes that are no answer.
#include "carom/rotation/hamilton_product.hpp"

#include <unistd.h>

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  const char noise[] = {8, 0, 0, 0, 77, 1, 2, 3, 4, 5, 6, 7};
  if (write(4, noise, sizeof noise) < 0) _exit(1);
  return {0, 0, 0, 0};
}

}  // namespace carom
