#include "carom/manifold/contact_ids.hpp"

#include <string>

#include "carom/core/errors.hpp"

namespace carom {
namespace {

std::uint32_t half(const Feature& feature) {
  constexpr std::uint32_t kIndices = 1u << 14;
  if (feature.index >= kIndices) {
    throw InvalidInput("contactIds: a feature has index " + std::to_string(feature.index) +
                       ", but 16383 is the largest that fits");
  }
  return (static_cast<std::uint32_t>(feature.kind) << 14) | feature.index;
}

}  // namespace

std::vector<std::uint32_t> contactIds(std::span<const FeaturePair> pairs) {
  std::vector<std::uint32_t> ids;
  for (const FeaturePair& pair : pairs) ids.push_back((half(pair.onA) << 16) | half(pair.onB));
  return ids;
}

}  // namespace carom
