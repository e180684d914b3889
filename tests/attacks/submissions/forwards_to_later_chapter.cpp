// Calls a function of a later chapter.
#include "carom/rotation/hamilton_product.hpp"

namespace carom {
double signedVolume(const double*);
}

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  const double q = 1;
  return {signedVolume(&q), 0, 0, 0};
}

}  // namespace carom
