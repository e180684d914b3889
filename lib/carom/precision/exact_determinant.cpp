#include "carom/precision/exact_determinant.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/precision/determinant.hpp"
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

// Valid until the next call.
const ExactSum& exactSum(const Corners& corners) {
  const auto& [o, a, b, c] = corners.points;
  thread_local ExactSum sum;  // a hull asks for thousands of them, one after the other
  sum.clear();
  addDeterminant(sum, a, b, c, 1);
  if (!o.isZero(0)) {  // linear in each column: terms with two times o vanish
    addDeterminant(sum, o, b, c, -1);
    addDeterminant(sum, a, o, c, -1);
    addDeterminant(sum, a, b, o, -1);
  }
  return sum;
}

// Not inlined: its many registers would be saved on the way through the filter too.
[[gnu::noinline]] int carefulOrientation(const Vector3& o, const Vector3& a, const Vector3& b,
                                         const Vector3& c, Real size) {
  // Twice the digits settle all but points in the plane: four operations deep, each within 7 *
  // 2^-106 of the terms, and the limit is a hundred times as much.
  if (size > 1e-150 && size < 1e300) {
    const Real more = tetrahedronDeterminant(o, a, b, c).high;
    if (std::abs(more) > 0x1p-95 * size) return more > 0 ? 1 : -1;
  }
  return exactSum(scaled(o, a, b, c)).sign();
}

}  // namespace

int orientation(const Vector3& o, const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 u = a - o, v = b - o, w = c - o;
  const Real yz = v.y() * w.z(), zy = v.z() * w.y(), zx = v.z() * w.x(), xz = v.x() * w.z(),
             xy = v.x() * w.y(), yx = v.y() * w.x();
  const Real ux = std::abs(u.x()), uy = std::abs(u.y()), uz = std::abs(u.z());
  const Real value = u.x() * (yz - zy) + u.y() * (zx - xz) + u.z() * (xy - yx);
  const Real size = ux * (std::abs(yz) + std::abs(zy)) + uy * (std::abs(zx) + std::abs(xz)) +
                    uz * (std::abs(xy) + std::abs(yx));
  // Shewchuk's bound (7 + 56 eps) eps, eps = 2^-53, for differences, products and sums together. It
  // does not know of underflow: what that costs the inner products is below 1e-322, and times the
  // outer factor, if that is below 1e100, below kUnderflow.
  constexpr Real kErrorBound = 7.0000000000001 * 0x1p-53, kUnderflow = 1e-200;
  if (std::abs(value) > kErrorBound * size + kUnderflow && ux + uy + uz < 1e100) {
    return value > 0 ? 1 : -1;
  }
  return carefulOrientation(o, a, b, c, size);
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
