// Exercise 02.monte_carlo_error: how fast the error of weighing by darts falls.
// Check it with: ./course check 02.monte_carlo_error

#include "monte_carlo_error.hpp"

#include <cmath>
#include <cstdint>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"
#include "carom/mass/monte_carlo_mass.hpp"
#include "carom/mass/signed_volume.hpp"

namespace carom {

std::vector<DartError> monteCarloError(const TriangleMesh& mesh, std::span<const int> sampleCounts,
                                       int seeds) {
  requirePositive(seeds, "seeds");
  const Real volume = signedVolume(mesh);
  requirePositive(volume, "volume");
  // For each number of darts: one run with each of the seeds 1, 2, ..., and one row of the table.
  return todo<std::vector<DartError>>("monteCarloError");
}

}  // namespace carom
