#include "carom/solver/warm_start.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"

namespace carom {

void warmStart(std::span<MovingBody> bodies, std::span<ContactRow> rows,
               std::span<const KeptImpulse> kept, Real ratio) {
  requireNonNegative(ratio, "ratio");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].impulse = i < kept.size() ? ratio * kept[i].impulse : 0;
    pushRow(rows[i], rows[i].impulse, bodies);
  }
}

}  // namespace carom
