// The same quotient the other way round: the gap closes at 1/caution, and the bound is 1 m/s.
#include "advance_cost.hpp"

#include "carom/core/checks.hpp"
#include "carom/toi/conservative_advancement.hpp"

namespace carom {

std::vector<AdvanceCost> advanceCost(Real caution, std::span<const Real> tolerances) {
  if (!(caution >= 1)) throw InvalidInput("caution below 1");
  std::vector<AdvanceCost> rows;
  rows.reserve(tolerances.size());
  for (const Real small : tolerances) {
    requirePositive(small, "tolerance");
    AdvanceCost& row = rows.emplace_back();
    row.tolerance = small;
    row.steps = conservativeAdvancement([=](Real t) { return 1 - t / caution; }, 1, 2 * caution,
                                        small, 100000000)
                    .steps;
  }
  return rows;
}

}  // namespace carom
