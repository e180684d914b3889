#include "carom/precision/exact_determinant.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/precision/exact_sum.hpp"

namespace carom {
namespace {

// Products of three coordinates must neither overflow nor lose their last digits below the smallest
// double: with coordinates in [2^-306, 2^300] their bits lie in [2^-1074, 2^900].
constexpr int kLargestExponent = 300;
constexpr Real kSmallest = 0x1p-306;

// det(a, b, c) or its negative.
void addDeterminant(ExactSum& sum, const Vector3& a, const Vector3& b, const Vector3& c,
                    Real sign) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum.addProduct(b(j), c(k), sign * a(i));
    sum.addProduct(b(k), c(j), -sign * a(i));
  }
}

struct Corners {
  std::array<Vector3, 4> points;
  int exponent = 0;  // given = points * 2^exponent
};

Corners scaled(const Vector3& o, const Vector3& a, const Vector3& b, const Vector3& c) {
  Corners result{{o, a, b, c}, 0};
  Real largest = 0;
  for (const Vector3& p : result.points) {
    requireFinite(p, "corner");
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  }
  if (largest == 0) return result;
  int e = 0;
  std::frexp(largest, &e);
  result.exponent = e - kLargestExponent;
  for (Vector3& p : result.points) {
    for (Real& x : p) {
      const Real given = x;
      x = std::ldexp(x, -result.exponent);
      if (given != 0 && std::abs(x) < kSmallest) {
        reject("coordinate", toText(given),
               "must be 0, or at least 2^-600 times the largest, " + toText(largest));
      }
    }
  }
  return result;
}

ExactSum exactSum(const Corners& corners) {
  const auto& [o, a, b, c] = corners.points;
  ExactSum sum;
  addDeterminant(sum, a, b, c, 1);
  if (!o.isZero(0)) {  // linear in each column: terms with two times o vanish
    addDeterminant(sum, o, b, c, -1);
    addDeterminant(sum, a, o, c, -1);
    addDeterminant(sum, a, b, o, -1);
  }
  return sum;
}

}  // namespace

int orientation(const Vector3& o, const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 u = a - o, v = b - o, w = c - o;
  Real value = 0, size = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    value += u(i) * (v(j) * w(k) - v(k) * w(j));
    size += std::abs(u(i)) * (std::abs(v(j) * w(k)) + std::abs(v(k) * w(j)));
  }
  // Shewchuk's bound (7 + 56 eps) eps, eps = 2^-53, for differences, products and sums together. It
  // does not know of underflow, hence the lower limit on size.
  constexpr Real kErrorBound = 7.0000000000001 * 0x1p-53;
  if (size > 1e-200 && std::abs(value) > kErrorBound * size && std::isfinite(size)) {
    return value > 0 ? 1 : -1;
  }
  return exactSum(scaled(o, a, b, c)).sign();
}

Real exactTetrahedronDeterminant(const Vector3& o, const Vector3& a, const Vector3& b,
                                 const Vector3& c) {
  const Corners corners = scaled(o, a, b, c);
  return std::ldexp(exactSum(corners).value(), 3 * corners.exponent);
}

Real exactDeterminant(const Vector3& a, const Vector3& b, const Vector3& c) {
  return exactTetrahedronDeterminant(Vector3::Zero(), a, b, c);
}

}  // namespace carom
