#include "carom/manifold/reduce_contacts.hpp"

#include <algorithm>
#include <array>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"

namespace carom {

std::vector<int> reduceContacts(std::span<const Vector3> corners,
                                std::span<const Real> separations) {
  const int n = static_cast<int>(corners.size());
  if (separations.size() != corners.size()) {
    throw InvalidInput("reduceContacts: there must be one separation per corner");
  }
  std::vector<int> kept;
  for (int i = 0; i < std::min(n, 4); ++i) kept.push_back(i);
  if (n <= 4) return kept;

  // Twice the area of the triangle of three corners.
  const auto area = [&](int i, int j, int k) {
    return cross(corners[j] - corners[i], corners[k] - corners[i]).norm();
  };
  const auto areaOfFour = [&](const std::vector<int>& q) {
    return area(q[0], q[1], q[2]) + area(q[0], q[2], q[3]);
  };

  // For each diagonal i-k the farthest corner j on one side and l on the other.
  Real largest = 0;
  Real reach = 0;  // longest diagonal
  for (int i = 0; i < n; ++i) {
    for (int k = i + 2; k < n; ++k) {
      reach = std::max(reach, (corners[k] - corners[i]).norm());
      int j = i + 1;
      for (int m = i + 2; m < k; ++m) {
        if (area(i, m, k) > area(i, j, k)) j = m;
      }
      int l = -1;
      for (int m = (k + 1) % n; m != i; m = (m + 1) % n) {
        if (l < 0 || area(i, k, m) > area(i, k, l)) l = m;
      }
      if (l < 0) continue;
      // A choice must be larger by a millionth: of equally good ones the first stays, whatever the
      // last digits of the corners are.
      constexpr Real kClearly = 1e-6;
      const Real total = area(i, j, k) + area(i, k, l);
      if (total > largest * (1 + kClearly)) {
        largest = total;
        kept = {i, j, k, l};
      }
    }
  }
  std::sort(kept.begin(), kept.end());

  // The deepest corner stays, in the place of one of its two neighbours.
  const int deepest = static_cast<int>(std::min_element(separations.begin(), separations.end()) -
                                       separations.begin());
  Real deepestKept = separations[kept[0]];
  for (const int i : kept) deepestKept = std::min(deepestKept, separations[i]);
  if (separations[deepest] < deepestKept - kDepthTie * reach) {
    std::vector<int> best;
    for (int replaced = 0; replaced < 4; ++replaced) {
      std::vector<int> trial = kept;
      trial[replaced] = deepest;
      std::sort(trial.begin(), trial.end());
      if (best.empty() || areaOfFour(trial) > areaOfFour(best)) best = trial;
    }
    kept = best;
  }
  return kept;
}

}  // namespace carom
