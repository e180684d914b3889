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
  std::uint32_t active = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (speeds[i] < 0) active |= 1u << i;
  }
  if (const auto impulses = stopRows(matrix, speeds, active)) return *impulses;
  throw InvalidInput("lcpSmall: no impulses keep these rows from approaching");
}

}  // namespace carom
