#include "sweep_factors.hpp"

#include <string>

#include "carom/core/checks.hpp"
#include "carom/solver/box_column.hpp"
#include "carom/solver/sequential_impulses.hpp"

namespace carom {

std::vector<SweepFactor> sweepFactors(std::span<const int> counts) {
  for (const int n : counts) {
    if (n < 2 || n > 200) reject("count", std::to_string(n), "must be from 2 to 200");
  }
  std::vector<SweepFactor> table;
  for (const int count : counts) {
    const int n = counts.front();
    BoxColumn column = boxColumn(std::vector<Real>(static_cast<std::size_t>(n), 1));
    pullDown(column.bodies, -1);
    sequentialImpulses(column.bodies, column.rows, n * n);
    const Real before = n - column.rows[0].impulse;
    sequentialImpulses(column.bodies, column.rows, 1);
    const Real after = n - column.rows[0].impulse;
    table.push_back({count, after / before});
  }
  return table;
}

}  // namespace carom
