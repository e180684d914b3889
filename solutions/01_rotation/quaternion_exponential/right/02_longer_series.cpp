// A longer series that reaches further.
#include "carom/rotation/quaternion_exponential.hpp"

#include <cmath>

namespace carom {

Quaternion quaternionExponential(const Vector3& rotationVector) {
  const Real angle = rotationVector.norm();
  const Real h = angle * angle / 4;
  const Real factor =
      h < 1e-4 ? (1 - h / 6 * (1 - h / 20 * (1 - h / 42))) / 2 : std::sin(angle / 2) / angle;
  const Vector3 v = factor * rotationVector;
  return {std::cos(angle / 2), v.x(), v.y(), v.z()};
}

}  // namespace carom
