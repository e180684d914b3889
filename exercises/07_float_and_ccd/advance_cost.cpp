// Exercise 07.advance_cost: measure what each digit of a safe search costs.
// Check it with: ./course check 07.advance_cost

#include "advance_cost.hpp"

#include <limits>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"
#include "carom/toi/conservative_advancement.hpp"

namespace carom {

std::vector<AdvanceCost> advanceCost(Real caution, std::span<const Real> tolerances) {
  // Given: what cannot be measured is refused.
  requireFinite(caution, "caution");
  if (caution < 1) reject("caution", toText(caution), "must be at least 1");
  for (const Real tolerance : tolerances) requirePositive(tolerance, "tolerance");
  [[maybe_unused]] const int most = std::numeric_limits<int>::max();  // never give up
  std::vector<AdvanceCost> table;
  // conservativeAdvancement(gap, fastest, duration, tolerance, most) searches; a gap can be a
  // lambda, const auto gap = [](Real time) { return ...; }; and table.push_back({x, n}) adds a row.
  return todo<std::vector<AdvanceCost>>("advanceCost");
}

}  // namespace carom
