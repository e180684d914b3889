#include "carom/solver/lcp_small.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "carom/core/checks.hpp"
#include "carom/solver/active_rows.hpp"

namespace carom {

std::vector<Real> lcpSmall(std::span<const Real> matrix, std::span<const Real> speeds) {
  const std::size_t n = speeds.size();
  if (n > 12) reject("speeds", std::to_string(n) + " numbers", "must be at most 12");
  if (matrix.size() != n * n) {
    reject("matrix", std::to_string(matrix.size()) + " numbers", "must have n times n");
  }
  Real little = 0;  // what rounding makes of zero [m/s]
  for (const Real speed : speeds) little = std::max(little, 1e-9 * std::abs(speed));
  for (std::uint32_t left = 1u << n; left > 0; --left) {
    const std::optional<std::vector<Real>> x = stopRows(matrix, speeds, left - 1);
    if (!x || std::any_of(x->begin(), x->end(), [](Real v) { return v < 0; })) continue;
    std::vector<Real> after(speeds.begin(), speeds.end());
    for (std::size_t k = 0; k < n * n; ++k) after[k / n] += matrix[k] * (*x)[k % n];
    if (n == 0 || *std::min_element(after.begin(), after.end()) >= -little) return *x;
  }
  throw InvalidInput("lcpSmall: no impulses keep these rows from approaching");
}

}  // namespace carom
