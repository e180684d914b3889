// Exercise 07.advance_cost: measure what each digit of a safe search costs.
// Check it with: ./course check 07.advance_cost

#include "advance_cost.hpp"

#include <limits>

#include "carom/core/checks.hpp"
#include "carom/toi/conservative_advancement.hpp"

namespace carom {

std::vector<AdvanceCost> advanceCost(Real caution, std::span<const Real> tolerances) {
  // Given: what cannot be measured is refused.
  requireFinite(caution, "caution");
  if (caution < 1) reject("caution", toText(caution), "must be at least 1");
  for (const Real tolerance : tolerances) requirePositive(tolerance, "tolerance");
  [[maybe_unused]] const int most = std::numeric_limits<int>::max();  // never give up
  std::vector<AdvanceCost> table;
  const auto gap = [](Real time) { return 1 - time; };
  int all = 0;
  for (const Real tolerance : tolerances) {
    const TimeOfImpact result = conservativeAdvancement(gap, caution, 2, tolerance, most);
    all += result.steps;
    table.push_back({tolerance, all});
  }
  return table;
}

}  // namespace carom
