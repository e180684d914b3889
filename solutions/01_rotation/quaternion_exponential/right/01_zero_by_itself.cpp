// Only zero needs care.
#include "carom/rotation/quaternion_exponential.hpp"

#include <cmath>

namespace carom {

Quaternion quaternionExponential(const Vector3& rotationVector) {
  const Real angle = rotationVector.norm();
  if (angle == 0) return {1, 0, 0, 0};
  const Vector3 v = std::sin(angle / 2) / angle * rotationVector;
  return {std::cos(angle / 2), v.x(), v.y(), v.z()};
}

}  // namespace carom
