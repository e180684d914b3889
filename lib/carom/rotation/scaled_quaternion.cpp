#include "carom/rotation/scaled_quaternion.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Quaternion scaledQuaternion(const Quaternion& q, const char* name) {
  const Real size = squaredNorm(q);
  if (size > 1e-120 && size < 1e120) return q;

  const Vector4 components(q.w, q.x, q.y, q.z);
  if (!components.allFinite()) reject(name, toText(components), "must be finite");
  const Real largest = components.cwiseAbs().maxCoeff();
  if (largest == 0) reject(name, toText(components), "must not be zero: it is no rotation");

  int e = 0;
  std::frexp(largest, &e);
  return {std::ldexp(q.w, -e), std::ldexp(q.x, -e), std::ldexp(q.y, -e), std::ldexp(q.z, -e)};
}

}  // namespace carom
