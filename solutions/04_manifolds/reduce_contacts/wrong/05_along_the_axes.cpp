// Exercise 04.reduce_contacts: which four of many contact points hold a body as all of them would?
// Check it with: ./course check 04.reduce_contacts

#include "carom/manifold/reduce_contacts.hpp"

#include <algorithm>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"

namespace carom {
namespace {

[[maybe_unused]] Real areaOfFour(std::span<const Vector3> corners, const std::vector<int>& four) {
  const auto area = [&](int i, int j, int k) {
    return cross(corners[j] - corners[i], corners[k] - corners[i]).norm();
  };
  return area(four[0], four[1], four[2]) + area(four[0], four[2], four[3]);
}

}  // namespace

std::vector<int> reduceContacts(std::span<const Vector3> corners,
                                std::span<const Real> separations) {
  [[maybe_unused]] const int n = static_cast<int>(corners.size());
  if (separations.size() != corners.size()) {
    throw InvalidInput("reduceContacts: there must be one separation per corner");
  }
  Real reach = 0;
  for (const Vector3& p : corners) {
    for (const Vector3& q : corners) reach = std::max(reach, (p - q).norm());
  }

  std::vector<int> kept;
  for (int i = 0; i < std::min(n, 4); ++i) kept.push_back(i);
  if (n <= 4) return kept;

  for (int k = 0; k < 4; ++k) {
    const int axis = k / 2;
    const Real sign = k % 2 ? -1 : 1;
    for (int i = 0; i < n; ++i) {
      if (sign * corners[i][axis] > sign * corners[kept[k]][axis]) kept[k] = i;
    }
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace carom
