#include "carom/mass/mesh_bounds.hpp"

#include <cstring>
#include <limits>

#include "carom/core/errors.hpp"
#include "carom/mass/four_lanes.hpp"

namespace carom {
namespace {

// Four vertices are three fours: x y z x, y z x y, z x y z. Each lane keeps to one coordinate.
struct Extremes {
  Four low[3], high[3];
};

CAROM_INLINE Four load(const Real* first) {
  Four result;
  std::memcpy(&result, first, sizeof result);
  return result;
}

// Over `groups` groups of four vertices. A comparison with a NaN is false, so NaNs are passed over.
CAROM_INLINE void findExtremes(const Real* first, std::size_t groups, Extremes& e) {
  constexpr Real kFar = std::numeric_limits<Real>::infinity();
  Four low0 = Four{} + kFar, low1 = low0, low2 = low0;
  Four high0 = -low0, high1 = high0, high2 = high0;
  for (std::size_t i = 0; i < groups; ++i) {
    const Real* p = first + 12 * i;
    const Four a = load(p), b = load(p + 4), c = load(p + 8);
    low0 = a < low0 ? a : low0;
    low1 = b < low1 ? b : low1;
    low2 = c < low2 ? c : low2;
    high0 = a > high0 ? a : high0;
    high1 = b > high1 ? b : high1;
    high2 = c > high2 ? c : high2;
  }
  e = {{low0, low1, low2}, {high0, high1, high2}};
}

void findExtremesBaseline(const Real* first, std::size_t groups, Extremes& e) {
  findExtremes(first, groups, e);
}

#if CAROM_HAS_TWINS
CAROM_AVX2 void findExtremesAvx2(const Real* first, std::size_t groups, Extremes& e) {
  findExtremes(first, groups, e);
}
#endif

}  // namespace

MeshBounds boundsOf(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) throw InvalidInput("boundsOf: the mesh has no vertices");

  constexpr Real kFar = std::numeric_limits<Real>::infinity();
  MeshBounds bounds{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  const auto include = [&bounds](Eigen::Index k, Real low, Real high) {
    bounds.low[k] = low < bounds.low[k] ? low : bounds.low[k];
    bounds.high[k] = high > bounds.high[k] ? high : bounds.high[k];
  };
  const std::size_t groups = mesh.vertices.size() / kLanes;
  if (groups > 0) {
    static_assert(sizeof(Vector3) == 3 * sizeof(Real), "vertices lie without gaps");
    Extremes e;
    const Real* first = mesh.vertices.front().data();
#if CAROM_HAS_TWINS
    if (lanesOfThisMachine() != Lanes::baseline) {
      findExtremesAvx2(first, groups, e);
    } else {
      findExtremesBaseline(first, groups, e);
    }
#else
    findExtremesBaseline(first, groups, e);
#endif
    for (std::size_t i = 0; i < 3 * kLanes; ++i) {
      include(static_cast<Eigen::Index>(i % 3), e.low[i / kLanes][i % kLanes],
              e.high[i / kLanes][i % kLanes]);
    }
  }
  for (std::size_t v = groups * kLanes; v < mesh.vertices.size(); ++v) {
    for (Eigen::Index k = 0; k < 3; ++k) include(k, mesh.vertices[v][k], mesh.vertices[v][k]);
  }
  return bounds;
}

}  // namespace carom
