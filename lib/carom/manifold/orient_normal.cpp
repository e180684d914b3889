#include "carom/manifold/orient_normal.hpp"

#include <algorithm>

#include "carom/core/errors.hpp"

namespace carom {

Vector3 orientNormal(const Vector3& axis, std::span<const Vector3> a, std::span<const Vector3> b) {
  if (a.empty() || b.empty()) {
    throw InvalidInput("orientNormal: each body must have at least one corner");
  }
  Real lowA = axis.dot(a.front()), highA = lowA;
  for (const Vector3& corner : a) {
    lowA = std::min(lowA, axis.dot(corner));
    highA = std::max(highA, axis.dot(corner));
  }
  Real lowB = axis.dot(b.front()), highB = lowB;
  for (const Vector3& corner : b) {
    lowB = std::min(lowB, axis.dot(corner));
    highB = std::max(highB, axis.dot(corner));
  }
  const Real forwards = highA - lowB;   // how far B has to go along the axis
  const Real backwards = highB - lowA;  // and against it
  return forwards <= backwards ? axis : Vector3(-axis);
}

}  // namespace carom
