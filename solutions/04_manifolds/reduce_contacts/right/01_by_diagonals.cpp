// For each diagonal the farthest corner on either side.
#include <algorithm>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/manifold/reduce_contacts.hpp"

namespace carom {

std::vector<int> reduceContacts(std::span<const Vector3> corners,
                                std::span<const Real> separations) {
  if (corners.size() != separations.size()) throw InvalidInput("a separation per corner");
  const int n = static_cast<int>(corners.size());
  std::vector<int> kept;
  if (n <= 4) {
    for (int i = 0; i < n; ++i) kept.push_back(i);
    return kept;
  }
  const auto triangle = [&](int i, int j, int k) {
    return cross(corners[j] - corners[i], corners[k] - corners[i]).norm();
  };
  Real largest = 0, reach = 0;
  for (int i = 0; i < n; ++i) {
    for (int k = i + 1; k < n; ++k) {
      reach = std::max(reach, (corners[i] - corners[k]).norm());
      int inside = -1, outside = -1;
      for (int m = 0; m < n; ++m) {
        if (m == i || m == k) continue;
        int& side = m > i && m < k ? inside : outside;
        if (side < 0 || triangle(i, k, m) > triangle(i, k, side)) side = m;
      }
      if (inside < 0 || outside < 0) continue;
      const Real area = triangle(i, k, inside) + triangle(i, k, outside);
      if (area > largest * (1 + 1e-12)) {
        largest = area;
        kept = {i, k, inside, outside};
      }
    }
  }
  std::sort(kept.begin(), kept.end());
  int deepest = 0;
  for (int i = 1; i < n; ++i) {
    if (separations[i] < separations[deepest]) deepest = i;
  }
  for (const int i : kept) {
    if (separations[deepest] >= separations[i] - kDepthTie * reach) return kept;
  }
  Real most = -1;
  std::vector<int> best;
  for (int gone = 0; gone < 4; ++gone) {
    std::vector<int> four = {deepest};
    for (int k = 0; k < 4; ++k) {
      if (k != gone) four.push_back(kept[k]);
    }
    std::sort(four.begin(), four.end());
    const Real area = triangle(four[0], four[1], four[2]) + triangle(four[0], four[2], four[3]);
    if (area > most) {
      most = area;
      best = four;
    }
  }
  return best;
}

}  // namespace carom
