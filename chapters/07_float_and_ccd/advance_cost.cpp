#include "advance_cost.hpp"

#include <limits>

#include "carom/core/checks.hpp"
#include "carom/toi/conservative_advancement.hpp"

namespace carom {

std::vector<AdvanceCost> advanceCost(Real caution, std::span<const Real> tolerances) {
  requireFinite(caution, "caution");
  if (caution < 1) reject("caution", toText(caution), "must be at least 1");
  const auto gap = [](Real time) { return 1 - time; };
  std::vector<AdvanceCost> table;
  for (const Real tolerance : tolerances) {
    if (!(tolerance >= 1e-15 * caution && tolerance < 1)) {
      reject("tolerance", toText(tolerance), "must be from 1e-15 times caution to 1");
    }
    const int most = std::numeric_limits<int>::max();
    table.push_back({tolerance, conservativeAdvancement(gap, caution, 2, tolerance, most).steps});
  }
  return table;
}

}  // namespace carom
