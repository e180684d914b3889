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

ExactVector edge(const Vector3& from, const Vector3& to) {
  return {exactDifference(to.x(), from.x()), exactDifference(to.y(), from.y()),
          exactDifference(to.z(), from.z())};
}

}  // namespace

DoubleDouble determinant(const Vector3& a, const Vector3& b, const Vector3& c) {
  return expand({a.x(), a.y(), a.z()}, {b.x(), b.y(), b.z()}, {c.x(), c.y(), c.z()});
}

DoubleDouble tetrahedronDeterminant(const Vector3& o, const Vector3& a, const Vector3& b,
                                    const Vector3& c) {
  return expand(edge(o, a), edge(o, b), edge(o, c));
}

}  // namespace carom
