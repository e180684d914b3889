#include "carom/solver/sequential_impulses.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "carom/core/checks.hpp"

namespace carom {

void sequentialImpulses(std::span<MovingBody> bodies, std::span<ContactRow> rows, int sweeps) {
  if (sweeps < 0) reject("sweeps", std::to_string(sweeps), "must not be negative");
  while (sweeps-- > 0) {
    for (ContactRow& row : rows) {
      Real more = (row.target - partingSpeed(row, bodies)) * rowMass(row, bodies);
      if (row.impulse + more < 0) more = -row.impulse;
      row.impulse += more;
      pushRow(row, more, bodies);
    }
  }
}

}  // namespace carom
