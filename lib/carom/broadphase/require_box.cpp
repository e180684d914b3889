#include "carom/broadphase/require_box.hpp"

#include "carom/core/checks.hpp"

namespace carom {

template <int Dim>
void requireBox(const Aabb<Dim>& box) {
  for (int i = 0; i < Dim; ++i) {
    // Written so that NaN fails it too.
    if (box.low(i) <= box.high(i)) continue;
    reject("box from " + toText(box.low(i)) + " to " + toText(box.high(i)),
           "on axis " + std::to_string(i), "must have its low side not above its high side");
  }
}

template void requireBox(const Aabb<2>& box);
template void requireBox(const Aabb<3>& box);

void requireItem(std::int32_t item) {
  if (item < 0 || item > (std::int32_t(1) << 30)) {
    reject("item", std::to_string(item), "must be from 0 to 2^30");
  }
}

}  // namespace carom
