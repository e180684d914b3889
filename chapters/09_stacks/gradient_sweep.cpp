#include "gradient_sweep.hpp"

#include <algorithm>

#include "carom/solver/sequential_impulses.hpp"

namespace carom {

void gradientSweep(std::span<MovingBody> bodies, std::span<ContactRow> rows,
                   GradientMemory& memory) {
  std::vector<Real> change;
  for (const ContactRow& row : rows) change.push_back(-row.impulse);
  sequentialImpulses(bodies, rows, 1);
  Real square = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    change[i] += rows[i].impulse;
    square += change[i] * change[i];
  }
  const bool falls = memory.direction.size() == rows.size() && square < memory.square;
  const Real share = falls ? square / memory.square : 0;
  for (std::size_t i = 0; falls && i < rows.size(); ++i) {
    const Real total = std::max(Real(0), rows[i].impulse + share * memory.direction[i]);
    pushRow(rows[i], total - rows[i].impulse, bodies);
    rows[i].impulse = total;
    change[i] += share * memory.direction[i];
  }
  memory.direction = change;
  memory.square = square;
}

}  // namespace carom
