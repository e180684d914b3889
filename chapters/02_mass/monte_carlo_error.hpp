#pragma once
// How fast does the error of weighing by darts fall with the number of darts?
//
// Method: for each number of darts, weigh the mesh once with each of many seeds, and take the root
// of the mean squared relative error of the volume. Why so many seeds: one throw may be lucky, and
// then says nothing about the method. Why squares: errors of both signs must not cancel. Source:
// the source text's method 2; a binomial spread, so the error is sqrt((1-p)/(pN)) for a share p of
// hits. Not handled: the error of centre and inertia, which falls as fast.

#include <span>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// The typical error of weighing with one number of darts. \ingroup mass
struct DartError {
  int samples = 0;         ///< darts thrown at the bounding box
  Real relativeError = 0;  ///< root mean square over the seeds of (estimated volume) / (volume) - 1
};

/// Measures how far monteCarloMass() is from the exact volume.
/// \param mesh a closed surface that looks outwards [m]
/// \param sampleCounts numbers of darts to try, all positive
/// \param seeds how many runs for each number: with the seeds 1, 2, ... up to this one
/// \return one row for each number of darts, in the order given
/// \throws InvalidInput if the mesh is unusable or has no volume, or a count or seeds is not
/// positive
/// \ingroup mass
std::vector<DartError> monteCarloError(const TriangleMesh& mesh, std::span<const int> sampleCounts,
                                       int seeds);

}  // namespace carom
