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
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const int n = counts[k];
    BoxColumn tower = boxColumn(std::vector<Real>(static_cast<std::size_t>(n), 1.0));
    pullDown(tower.bodies, -1);
    std::vector<Real> errors;
    for (int sweep = 0; sweep <= n * n; ++sweep) {
      sequentialImpulses(tower.bodies, tower.rows, 1);
      errors.push_back(n - tower.rows.front().impulse);
    }
    table.push_back({n, errors.back() / errors[errors.size() - 2]});
  }
  return table;
}

}  // namespace carom
