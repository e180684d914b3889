#include "carom/rotation/renormalize.hpp"

#include <cmath>

#include "carom/rotation/scaled_quaternion.hpp"

namespace carom {

Quaternion renormalize(const Quaternion& q) {
  const Quaternion s = scaledQuaternion(q, "q");
  const Real norm = std::sqrt(squaredNorm(s));
  return {s.w / norm, s.x / norm, s.y / norm, s.z / norm};
}

}  // namespace carom
