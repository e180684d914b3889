// Instantiates templates without end.
#include "carom/rotation/hamilton_product.hpp"

template <int N>
struct Deep {
  static constexpr int value = Deep<N + 1>::value + 1;
};

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {static_cast<double>(Deep<0>::value), 0, 0, 0};
}

}  // namespace carom
