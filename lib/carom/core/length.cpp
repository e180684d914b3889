#include "carom/core/length.hpp"

namespace carom {

Vector3 scaledToOne(const Vector3& v, int* exponent) {
  const Real largest = v.cwiseAbs().maxCoeff();
  int e = 0;
  if (largest > 0 && v.allFinite()) std::frexp(largest, &e);
  if (exponent != nullptr) *exponent = e;
  return {std::ldexp(v.x(), -e), std::ldexp(v.y(), -e), std::ldexp(v.z(), -e)};
}

}  // namespace carom
