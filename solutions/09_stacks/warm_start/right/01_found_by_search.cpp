#include "carom/solver/warm_start.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"

namespace carom {

void warmStart(std::span<MovingBody> bodies, std::span<ContactRow> rows,
               std::span<const KeptImpulse> kept, Real ratio) {
  requireNonNegative(ratio, "ratio");
  for (ContactRow& row : rows) {
    const auto old = std::find_if(kept.begin(), kept.end(),
                                  [&](const KeptImpulse& k) { return k.name == row.name; });
    row.impulse = old == kept.end() ? 0 : ratio * old->impulse;
  }
  for (const ContactRow& row : rows) pushRow(row, row.impulse, bodies);
}

}  // namespace carom
