#include <tight_inclusion/ccd.hpp>

#include "bench/toi_peers.hpp"

namespace carom::bench {

PeerImpact featuresInTightInclusion(bool face, const double* points, double tolerance) {
  const auto at = [points](int i) {
    return ticcd::Vector3(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
  };
  constexpr long kMostBoxes = 1000000;
  const ticcd::Array3 noScene(-1, -1, -1);
  PeerImpact result;
  double reached = 0;
  const auto query = face ? ticcd::vertexFaceCCD : ticcd::edgeEdgeCCD;
  result.hit = query(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), noScene, 0,
                     result.time, tolerance, 1, kMostBoxes, reached, ticcd::DEFAULT_NO_ZERO_TOI,
                     ticcd::CCDRootFindingMethod::BREADTH_FIRST_SEARCH);
  return result;
}

}  // namespace carom::bench
