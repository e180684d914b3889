#include "carom/solver/soft_sweep.hpp"

#include <algorithm>

namespace carom {

void softSweep(std::span<MovingBody> bodies, std::span<ContactRow> rows, const SoftContact& soft,
               Real dt) {
  for (ContactRow& row : rows) {
    const bool apart = row.separation > 0;
    const SoftContact s = apart ? SoftContact{} : soft;
    const Real push = std::max(s.biasRate * row.separation, -kFastestPush);
    const Real bias = apart ? row.separation / dt : push;
    const Real wrong = partingSpeed(row, bodies) + bias;
    const Real change = -s.massScale * rowMass(row, bodies) * wrong - s.impulseScale * row.impulse;
    const Real total = std::max(Real(0), row.impulse + change);
    pushRow(row, total - row.impulse, bodies);
    row.impulse = total;
  }
}

}  // namespace carom
