// Exercise 04.contact_ids: names that contact points keep from step to step.
// Check it with: ./course check 04.contact_ids

#include "carom/manifold/contact_ids.hpp"

#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"

namespace carom {

std::vector<std::uint32_t> contactIds(std::span<const FeaturePair> pairs) {
  // Given: an index that does not fit is refused.
  for (const FeaturePair& pair : pairs) {
    if (pair.onA.index >= 16384 || pair.onB.index >= 16384) {
      throw InvalidInput("contactIds: the index of a feature must be below 16384");
    }
  }
  //# solution
  const auto half = [](const Feature& feature) {
    return (static_cast<std::uint32_t>(feature.kind) << 14) | feature.index;
  };
  std::vector<std::uint32_t> ids;
  for (const FeaturePair& pair : pairs) ids.push_back((half(pair.onA) << 16) | half(pair.onB));
  return ids;
  //# stub
  // static_cast<std::uint32_t>(feature.kind) is the kind as a number from 0 to 3. x << 14 moves the
  // bits of x up by 14 places, and x | y joins the bits of two numbers.
  //#| return todo<std::vector<std::uint32_t>>("contactIds");
  //# end
}

}  // namespace carom
