// Exercise 04.orient_normal: which of the two directions of an axis points from A to B?
// Check it with: ./course check 04.orient_normal

#include "carom/manifold/orient_normal.hpp"

#include "carom/core/errors.hpp"
#include "carom/detection/project.hpp"

namespace carom {

Vector3 orientNormal(const Vector3& axis, std::span<const Vector3> a, std::span<const Vector3> b) {
  if (a.empty() || b.empty()) {
    throw InvalidInput("orientNormal: each body must have at least one corner");
  }
  Vector3 centreA = Vector3::Zero();
  for (const Vector3& p : a) centreA += p / static_cast<Real>(a.size());
  Vector3 centreB = Vector3::Zero();
  for (const Vector3& q : b) centreB += q / static_cast<Real>(b.size());
  return axis.dot(centreB - centreA) >= 0 ? axis : Vector3(-axis);
}

}  // namespace carom
