#include "carom/solver/sequential_impulses.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "carom/core/checks.hpp"

namespace carom {

void sequentialImpulses(std::span<MovingBody> bodies, std::span<ContactRow> rows, int sweeps) {
  if (sweeps < 0) reject("sweeps", std::to_string(sweeps), "must not be negative");
  std::vector<Real> masses;
  for (const ContactRow& row : rows) masses.push_back(rowMass(row, bodies));
  for (int visit = 0; visit < sweeps * static_cast<int>(rows.size()); ++visit) {
    const std::size_t i = static_cast<std::size_t>(visit) % rows.size();
    const Real old = rows[i].impulse;
    const Real free = old - masses[i] * (partingSpeed(rows[i], bodies) - rows[i].target);
    rows[i].impulse = free > 0 ? free : 0;
    pushRow(rows[i], rows[i].impulse - old, bodies);
  }
}

}  // namespace carom
