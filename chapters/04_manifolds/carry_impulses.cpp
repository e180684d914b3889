#include "carry_impulses.hpp"

#include <string>

#include "carom/core/errors.hpp"

namespace carom {

//! [carry]
std::vector<Real> carryImpulses(std::span<const std::uint32_t> oldIds,
                                std::span<const Real> oldImpulses,
                                std::span<const std::uint32_t> newIds) {
  if (oldIds.size() != oldImpulses.size()) {
    throw InvalidInput("carryImpulses: there are " + std::to_string(oldIds.size()) + " names but " +
                       std::to_string(oldImpulses.size()) + " impulses");
  }
  std::vector<Real> impulses(newIds.size(), 0);
  for (std::size_t i = 0; i < newIds.size(); ++i) {
    for (std::size_t k = 0; k < oldIds.size(); ++k) {
      if (oldIds[k] == newIds[i]) impulses[i] = oldImpulses[k];
    }
  }
  return impulses;
}
//! [carry]

}  // namespace carom
