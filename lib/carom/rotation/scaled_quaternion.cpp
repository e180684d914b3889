#include "carom/rotation/scaled_quaternion.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Quaternion scaledQuaternion(const Quaternion& q, const char* name) {
  const Real size = squaredNorm(q);
  if (size > 1e-120 && size < 1e120) return q;

  const auto text = [&q] {
    return "(" + toText(q.w) + ", " + toText(q.x) + ", " + toText(q.y) + ", " + toText(q.z) + ")";
  };
  const bool finite =
      std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
  if (!finite) reject(name, text(), "must be finite");
  const Real largest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  if (largest == 0) reject(name, text(), "must not be zero: it is no rotation");

  int e = 0;
  std::frexp(largest, &e);
  return {std::ldexp(q.w, -e), std::ldexp(q.x, -e), std::ldexp(q.y, -e), std::ldexp(q.z, -e)};
}

}  // namespace carom
