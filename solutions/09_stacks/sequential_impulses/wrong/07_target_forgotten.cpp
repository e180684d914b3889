#include "carom/solver/sequential_impulses.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "carom/core/checks.hpp"

namespace carom {

void sequentialImpulses(std::span<MovingBody> bodies, std::span<ContactRow> rows, int sweeps) {
  if (sweeps < 0) reject("sweeps", std::to_string(sweeps), "must not be negative");
  for (int n = 0; n < sweeps; ++n) {
    for (ContactRow& row : rows) {
      const Real more = -rowMass(row, bodies) * partingSpeed(row, bodies);
      const Real total = std::max(Real(0), row.impulse + more);
      pushRow(row, total - row.impulse, bodies);
      row.impulse = total;
    }
  }
}

}  // namespace carom
