#include "monte_carlo_error.hpp"

#include <cmath>
#include <cstdint>

#include "carom/core/checks.hpp"
#include "carom/mass/monte_carlo_mass.hpp"
#include "carom/mass/signed_volume.hpp"

namespace carom {

std::vector<DartError> monteCarloError(const TriangleMesh& mesh, std::span<const int> sampleCounts,
                                       int seeds) {
  requirePositive(seeds, "seeds");
  const Real volume = signedVolume(mesh);
  requirePositive(volume, "volume");
  std::vector<DartError> table;
  for (const int samples : sampleCounts) {
    Real squares = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
      const MonteCarloMass run = monteCarloMass(mesh, 1, samples, static_cast<std::uint64_t>(seed));
      const Real error = run.body.volume / volume - 1;
      squares += std::abs(error);
    }
    table.push_back({samples, squares / seeds});
  }
  return table;
}

}  // namespace carom
