// A dictionary from names to impulses.
#include "carry_impulses.hpp"

#include <map>

#include "carom/core/errors.hpp"

namespace carom {

std::vector<Real> carryImpulses(std::span<const std::uint32_t> oldIds,
                                std::span<const Real> oldImpulses,
                                std::span<const std::uint32_t> newIds) {
  if (oldIds.size() != oldImpulses.size())
    throw InvalidInput("names and impulses differ in number");
  std::map<std::uint32_t, Real> memory;
  for (std::size_t k = 0; k < oldIds.size(); ++k) memory[oldIds[k]] = oldImpulses[k];
  std::vector<Real> impulses;
  for (const std::uint32_t id : newIds) {
    const auto known = memory.find(id);
    impulses.push_back(known == memory.end() ? Real(0) : known->second);
  }
  return impulses;
}

}  // namespace carom
