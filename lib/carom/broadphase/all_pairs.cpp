#include "carom/broadphase/all_pairs.hpp"

#include "carom/broadphase/require_box.hpp"

namespace carom {

std::vector<IndexPair> allPairs(std::span<const Aabb<3>> boxes) {
  for (const Aabb<3>& box : boxes) requireBox(box);

  //! [all pairs]
  std::vector<IndexPair> pairs;
  const auto count = static_cast<std::int32_t>(boxes.size());
  for (std::int32_t a = 0; a < count; ++a) {
    for (std::int32_t b = a + 1; b < count; ++b) {
      if (meets(boxes[a], boxes[b])) pairs.push_back({a, b});
    }
  }
  //! [all pairs]
  return pairs;
}

}  // namespace carom
