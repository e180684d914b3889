// From the hits alone: share of hits times the box, against the exact share.
#include "monte_carlo_error.hpp"

#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/mass/monte_carlo_mass.hpp"
#include "carom/mass/signed_volume.hpp"

namespace carom {

std::vector<DartError> monteCarloError(const TriangleMesh& mesh, std::span<const int> sampleCounts,
                                       int seeds) {
  if (seeds < 1) throw InvalidInput("monteCarloError needs at least one seed");
  const Real volume = signedVolume(mesh);
  Vector3 low = mesh.vertices[0];
  Vector3 high = low;
  for (const Vector3& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const Real share = volume / (high - low).prod();
  std::vector<DartError> table(sampleCounts.size());
  for (std::size_t row = 0; row < table.size(); ++row) {
    const int samples = sampleCounts[row];
    const Real expected = share * samples;
    Real squares = 0;
    for (int n = seeds; n >= 1; --n) {
      const auto run = monteCarloMass(mesh, 2, samples, static_cast<std::uint64_t>(n));
      squares += std::pow(run.inside - expected, 2);
    }
    table[row] = {samples, std::sqrt(squares / seeds) / expected};
  }
  return table;
}

}  // namespace carom
