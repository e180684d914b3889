#include "carom/solver/warm_start.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"

namespace carom {

void warmStart(std::span<MovingBody> bodies, std::span<ContactRow> rows,
               std::span<const KeptImpulse> kept, Real ratio) {
  requireNonNegative(ratio, "ratio");
  for (ContactRow& row : rows) {
    for (const KeptImpulse& old : kept) {
      if (old.name == row.name) row.impulse += ratio * old.impulse;
    }
    pushRow(row, row.impulse, bodies);
  }
}

}  // namespace carom
