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
  std::vector<Real> impulses(newIds.size(), 0);
  for (std::size_t i = 0; i < newIds.size() && i < oldImpulses.size(); ++i) {
    impulses[i] = oldImpulses[i];
  }
  return impulses;
}

}  // namespace carom
