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
  //# solution
  std::vector<DartError> table;
  for (const int samples : sampleCounts) {
    // Squares, so that errors of both signs do not cancel.
    Real squares = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
      const MonteCarloMass run = monteCarloMass(mesh, 1, samples, static_cast<std::uint64_t>(seed));
      const Real error = run.body.volume / volume - 1;
      squares += error * error;
    }
    table.push_back({samples, std::sqrt(squares / seeds)});
  }
  return table;
  //# stub
  // For each number of darts: one run with each of the seeds 1, 2, ..., and one row of the table.
  //#| return todo<std::vector<DartError>>("monteCarloError");
  //# end
}

}  // namespace carom
