#include "carom/rotation/renormalize.hpp"

#include <cmath>

#include "carom/rotation/scaled_quaternion.hpp"

namespace carom {
namespace {
constexpr Real kAlreadyOne =
    0x1p-51;  // |q|^2 this close to 1: |q| within an ulp, as near as can be
}

Quaternion renormalize(const Quaternion& q) {
  const Quaternion s = scaledQuaternion(q, "q");
  const Real squared = squaredNorm(s);
  if (std::abs(squared - 1) <= kAlreadyOne) return s;  // to divide would only round once more
  const Real norm = std::sqrt(squared);
  return {s.w / norm, s.x / norm, s.y / norm, s.z / norm};
}

}  // namespace carom
