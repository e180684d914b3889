#include "carom/solver/warm_start.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"

namespace carom {

void warmStart(std::span<MovingBody> bodies, std::span<ContactRow> rows,
               std::span<const KeptImpulse> kept, Real ratio) {
  requireNonNegative(ratio, "ratio");
  for (ContactRow& row : rows) {
    row.impulse = 0;
    for (const KeptImpulse& old : kept) {
      if (old.name != row.name) continue;
      row.impulse = ratio * old.impulse;
      pushRow(row, old.impulse, bodies);
    }
  }
}

}  // namespace carom
