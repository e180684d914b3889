#include "carom/precision/determinant.hpp"

#include <array>

namespace carom {
namespace {

using ExactVector = std::array<DoubleDouble, 3>;

DoubleDouble expand(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
  const DoubleDouble x = b[1] * c[2] - b[2] * c[1];
  const DoubleDouble y = b[2] * c[0] - b[0] * c[2];
  const DoubleDouble z = b[0] * c[1] - b[1] * c[0];
  return a[0] * x + a[1] * y + a[2] * z;
}

ExactVector exactDifference(const Vector3& a, const Vector3& b) {
  return {exactDifference(a.x(), b.x()), exactDifference(a.y(), b.y()),
          exactDifference(a.z(), b.z())};
}

}  // namespace

DoubleDouble determinant(const Vector3& a, const Vector3& b, const Vector3& c) {
  return expand({a.x(), a.y(), a.z()}, {b.x(), b.y(), b.z()}, {c.x(), c.y(), c.z()});
}

DoubleDouble tetrahedronDeterminant(const Vector3& o, const Vector3& a, const Vector3& b,
                                    const Vector3& c) {
  return expand(exactDifference(a, o), exactDifference(b, o), exactDifference(c, o));
}

}  // namespace carom
