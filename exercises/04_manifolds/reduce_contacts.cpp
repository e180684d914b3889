// Exercise 04.reduce_contacts: which four of many contact points hold a body as all of them would?
// Check it with: ./course check 04.reduce_contacts

#include "carom/manifold/reduce_contacts.hpp"

#include <algorithm>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"

namespace carom {
namespace {

// Given: twice the area of the quadrilateral of four corners, numbers in ascending order.
[[maybe_unused]] Real areaOfFour(std::span<const Vector3> corners, const std::vector<int>& four) {
  const auto area = [&](int i, int j, int k) {
    return cross(corners[j] - corners[i], corners[k] - corners[i]).norm();
  };
  return area(four[0], four[1], four[2]) + area(four[0], four[2], four[3]);
}

}  // namespace

std::vector<int> reduceContacts(std::span<const Vector3> corners,
                                std::span<const Real> separations) {
  // Given: each corner needs its separation, and the longest distance of two corners.
  [[maybe_unused]] const int n = static_cast<int>(corners.size());
  if (separations.size() != corners.size()) {
    throw InvalidInput("reduceContacts: there must be one separation per corner");
  }
  Real reach = 0;
  for (const Vector3& p : corners) {
    for (const Vector3& q : corners) reach = std::max(reach, (p - q).norm());
  }
  // First the four that span the largest area, then the deepest corner. There are few corners:
  // trying all choices of four is quick enough.
  return todo<std::vector<int>>("reduceContacts");
}

}  // namespace carom
