#include "carom/manifold/loop_manifold.hpp"

namespace carom::detail {
namespace {

Real doubledArea(const ClipCorner& a, const ClipCorner& b, const ClipCorner& c) {
  return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

}  // namespace

void reduceLoop(const ClipCorner* loop, const int* index, int n, int* chosen) {
  // Twice around, so that no index has to be wrapped.
  Real x[2 * kMostCorners], y[2 * kMostCorners];
  for (int i = 0; i < n; ++i) {
    x[i] = x[i + n] = loop[index[i]].x;
    y[i] = y[i + n] = loop[index[i]].y;
  }
  const auto corner = [&](int i) -> const ClipCorner& { return loop[index[i]]; };
  // A choice must be better by a millionth: of equally good ones the first stays, whatever the last
  // digits of the corners are.
  constexpr Real kClearly = 1e-6;
  int kept[4] = {0, 1, 2, 3};
  Real largest = 0;
  Real reach = 0;
  for (int i = 0; i + 2 < n; ++i) {
    // Around a convex loop the farthest corners j and l on either side of the diagonal i-k move on
    // as k does; so neither has to be searched from the start.
    int j = i + 1, l = i + 3;
    for (int k = i + 2; k < n && k - i < n - 1; ++k) {
      const Real dx = x[k] - x[i], dy = y[k] - y[i];
      reach = std::max(reach, dx * dx + dy * dy);
      const auto distance = [&](int m) {
        return std::abs(dx * (y[m] - y[i]) - dy * (x[m] - x[i]));
      };
      const auto farthest = [&](int m, int end) {
        Real here = distance(m);
        for (; m + 1 < end; ++m) {
          const Real next = distance(m + 1);
          if (!(next > here * (1 + kClearly)) && here > 0) break;
          here = next;
        }
        return m;
      };
      j = farthest(j, k);
      l = farthest(std::max(l, k + 1), i + n);
      const Real total = distance(j) + distance(l);
      if (total > largest * (1 + kClearly)) {
        largest = total;
        kept[0] = i;
        kept[1] = j;
        kept[2] = k;
        kept[3] = l < n ? l : l - n;
      }
    }
  }
  std::sort(kept, kept + 4);

  // The deepest corner stays, in the place of the neighbour that costs least area.
  int deepest = 0;
  for (int i = 1; i < n; ++i) {
    if (corner(i).height < corner(deepest).height) deepest = i;
  }
  Real deepestKept = corner(kept[0]).height;
  for (const int i : kept) deepestKept = std::min(deepestKept, corner(i).height);
  if (corner(deepest).height < deepestKept - kDepthTie * std::sqrt(reach)) {
    int best[4] = {0, 0, 0, 0};
    Real most = -1;
    for (int replaced = 0; replaced < 4; ++replaced) {
      int trial[4] = {kept[0], kept[1], kept[2], kept[3]};
      trial[replaced] = deepest;
      std::sort(trial, trial + 4);
      const Real area = doubledArea(corner(trial[0]), corner(trial[1]), corner(trial[2])) +
                        doubledArea(corner(trial[0]), corner(trial[2]), corner(trial[3]));
      if (area > most) {
        most = area;
        std::copy(trial, trial + 4, best);
      }
    }
    std::copy(best, best + 4, kept);
  }
  for (int k = 0; k < 4; ++k) chosen[k] = index[kept[k]];
}

void keepDeepest(const Vector3& position, Real separation, Real reach, std::uint32_t id,
                 Manifold& manifold) {
  const auto distance = [&](int k) { return (manifold.points[k].position - position).norm(); };
  int nearest = 0;
  for (int k = 0; k < manifold.count; ++k) {
    if (manifold.points[k].separation <= separation + kDepthTie * reach) return;
    if (distance(k) < distance(nearest)) nearest = k;
  }
  if (manifold.count == 0) manifold.areaCentroid = position;
  constexpr Real kNear = 0.1;
  const bool near = manifold.count > 0 && distance(nearest) < kNear * reach;
  const bool beside = !near && manifold.count < 4;
  ManifoldPoint& point = manifold.points[beside ? manifold.count++ : nearest];
  point.position = position;
  point.separation = separation;
  if (beside) point.id = id;
}

}  // namespace carom::detail
