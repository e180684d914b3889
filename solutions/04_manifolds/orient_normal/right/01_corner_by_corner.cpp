// Without shadows: the deepest corner of B either way.
#include <algorithm>
#include <limits>

#include "carom/core/errors.hpp"
#include "carom/manifold/orient_normal.hpp"

namespace carom {

Vector3 orientNormal(const Vector3& axis, std::span<const Vector3> a, std::span<const Vector3> b) {
  if (a.empty() || b.empty()) throw InvalidInput("a body has no corners");
  Real out = -std::numeric_limits<Real>::infinity();
  Real back = out;
  for (const Vector3& p : a) {
    for (const Vector3& q : b) {
      out = std::max(out, axis.dot(p - q));
      back = std::max(back, axis.dot(q - p));
    }
  }
  if (out > back) return -axis;
  return axis;
}

}  // namespace carom
