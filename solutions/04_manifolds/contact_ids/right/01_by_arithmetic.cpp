// With products and sums instead of bits.
#include "carom/core/errors.hpp"
#include "carom/manifold/contact_ids.hpp"

namespace carom {

std::vector<std::uint32_t> contactIds(std::span<const FeaturePair> pairs) {
  std::vector<std::uint32_t> ids(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::uint32_t id = 0;
    for (const Feature& feature : {pairs[i].onA, pairs[i].onB}) {
      if (feature.index > 16383) throw InvalidInput("an index has 14 bits");
      id = id * 65536 + static_cast<std::uint32_t>(feature.kind) * 16384 + feature.index;
    }
    ids[i] = id;
  }
  return ids;
}

}  // namespace carom
