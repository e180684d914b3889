// Exercise 04.carry_impulses: what a contact point remembers, which somebody got wrong.
// Check it with: ./course check 04.carry_impulses

#include "carry_impulses.hpp"

#include "carom/core/errors.hpp"

namespace carom {

std::vector<Real> carryImpulses(std::span<const std::uint32_t> oldIds,
                                std::span<const Real> oldImpulses,
                                std::span<const std::uint32_t> newIds) {
  if (oldIds.size() != oldImpulses.size()) {
    throw InvalidInput("carryImpulses: every name of the last step needs its impulse");
  }
  Real mean = 0;
  for (const Real j : oldImpulses) mean += j / static_cast<Real>(oldImpulses.size());
  std::vector<Real> impulses(newIds.size(), mean);
  for (std::size_t i = 0; i < newIds.size(); ++i) {
    for (std::size_t k = 0; k < oldIds.size(); ++k) {
      if (oldIds[k] == newIds[i]) impulses[i] = oldImpulses[k];
    }
  }
  return impulses;
}

}  // namespace carom
