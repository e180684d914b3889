// Exercise 04.contact_ids: names that contact points keep from step to step.
// Check it with: ./course check 04.contact_ids

#include "carom/manifold/contact_ids.hpp"

#include "carom/core/errors.hpp"

namespace carom {

std::vector<std::uint32_t> contactIds(std::span<const FeaturePair> pairs) {
  for (const FeaturePair& pair : pairs) {
    if (pair.onA.index >= 16384 || pair.onB.index >= 16384) {
      throw InvalidInput("contactIds: the index of a feature must be below 16384");
    }
  }
  const auto half = [](const Feature& feature) { return feature.index; };
  std::vector<std::uint32_t> ids;
  for (const FeaturePair& pair : pairs) ids.push_back((half(pair.onA) << 16) | half(pair.onB));
  return ids;
}

}  // namespace carom
