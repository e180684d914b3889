#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include "bench/toi_peers.hpp"

namespace carom::bench {

PeerImpact featuresInFcl(bool face, const double* points) {
  const auto at = [points](int i) {
    return fcl::Vector3d(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
  };
  using Features = fcl::detail::Intersect<double>;
  PeerImpact result;
  fcl::Vector3d point;
  if (face) {
    // The vertex comes last there.
    result.hit = Features::intersect_VF(at(1), at(2), at(3), at(0), at(5), at(6), at(7), at(4),
                                        &result.time, &point);
  } else {
    result.hit = Features::intersect_EE(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7),
                                        &result.time, &point);
  }
  return result;
}

}  // namespace carom::bench
