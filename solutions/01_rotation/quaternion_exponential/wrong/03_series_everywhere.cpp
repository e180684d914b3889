#include "carom/rotation/quaternion_exponential.hpp"

#include <cmath>

namespace carom {

Quaternion quaternionExponential(const Vector3& rotationVector) {
  const Real angle = rotationVector.norm();
  const Vector3 v = (0.5 - angle * angle / 48) * rotationVector;
  return {1 - angle * angle / 8, v.x(), v.y(), v.z()};
}

}  // namespace carom
