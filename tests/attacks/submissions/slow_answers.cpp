// Takes just less than the limit for each of many questions.
#include "carom/rotation/hamilton_product.hpp"

#include <unistd.h>

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  usleep(400000);
  return {0, 0, 0, 0};
}

}  // namespace carom
