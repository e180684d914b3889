#include "carom/solver/active_rows.hpp"

#include <cmath>
#include <utility>

namespace carom {

RowProblem rowProblem(std::span<const MovingBody> bodies, std::span<const ContactRow> rows) {
  const std::size_t n = rows.size();
  RowProblem problem;
  problem.matrix.resize(n * n);
  for (const ContactRow& row : rows) {
    problem.speeds.push_back(partingSpeed(row, bodies) - row.target);
  }
  std::vector<MovingBody> resting(bodies.begin(), bodies.end());
  for (std::size_t j = 0; j < n; ++j) {
    for (MovingBody& body : resting) body.velocity = {};
    pushRow(rows[j], 1, resting);
    for (std::size_t i = 0; i < n; ++i) problem.matrix[i * n + j] = partingSpeed(rows[i], resting);
  }
  return problem;
}

std::optional<std::vector<Real>> stopRows(std::span<const Real> matrix,
                                          std::span<const Real> speeds, std::uint32_t active) {
  const std::size_t n = speeds.size();
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < n; ++i) {
    if ((active >> i & 1u) != 0) chosen.push_back(i);
  }
  const std::size_t m = chosen.size();
  std::vector<std::vector<Real>> a(m, std::vector<Real>(m + 1));  // last column: right side
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j) a[i][j] = matrix[chosen[i] * n + chosen[j]];
    a[i][m] = -speeds[chosen[i]];
  }
  // A pivot this small beside its diagonal is what rounding leaves of nothing.
  constexpr Real kNothing = 1e-12;
  for (std::size_t k = 0; k < m; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < m; ++i) {
      if (std::abs(a[i][k]) > std::abs(a[best][k])) best = i;
    }
    std::swap(a[k], a[best]);
    if (!(std::abs(a[k][k]) > kNothing * matrix[chosen[k] * n + chosen[k]])) return {};
    for (std::size_t i = k + 1; i < m; ++i) {
      const Real factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j <= m; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  std::vector<Real> x(n, 0);
  for (std::size_t k = m; k-- > 0;) {
    Real sum = a[k][m];
    for (std::size_t j = k + 1; j < m; ++j) sum -= a[k][j] * x[chosen[j]];
    x[chosen[k]] = sum / a[k][k];
  }
  return x;
}

}  // namespace carom
