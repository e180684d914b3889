// Instantiates 2^40 templates, none of them deep.
#include "carom/rotation/hamilton_product.hpp"

template <int Depth, unsigned long Path>
struct Wide {
  static constexpr unsigned long value =
      Wide<Depth - 1, 2 * Path>::value + Wide<Depth - 1, 2 * Path + 1>::value;
};
template <unsigned long Path>
struct Wide<0, Path> {
  static constexpr unsigned long value = Path;
};

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {static_cast<double>(Wide<40, 1>::value), 0, 0, 0};
}

}  // namespace carom
