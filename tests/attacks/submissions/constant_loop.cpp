// Makes the compiler count for ever.
#include "carom/rotation/hamilton_product.hpp"

constexpr unsigned long count() {
  unsigned long sum = 0;
  for (unsigned long i = 0; i < 1000; ++i) {
    for (unsigned long j = 0; j < 1000; ++j) {
      for (unsigned long k = 0; k < 1000; ++k) sum += i ^ j ^ k;
    }
  }
  return sum;
}
constexpr unsigned long counted = count();

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {static_cast<double>(counted), 0, 0, 0};
}

}  // namespace carom
