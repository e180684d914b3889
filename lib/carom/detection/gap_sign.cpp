#include "carom/detection/gap_sign.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/core/length.hpp"
#include "carom/precision/exact_sum.hpp"

namespace carom {
namespace {

// |b - a|^2 - (r + s)^2, exactly, of numbers divided by 2^exponent. With the largest below 2^200
// and all others above 2^-300 no product over- or underflows. It stays until the thread asks for the
// next one, whose memory it is: balls of a heap ask in each step.
const ExactSum& exactGap(const Vector3& a, Real r, const Vector3& b, Real s, int& exponent) {
  const Real largest = std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), r, s});
  std::frexp(largest, &exponent);
  exponent -= 200;
  const auto scaled = [&](Real x) {
    const Real y = std::ldexp(x, -exponent);
    return std::abs(y) < 0x1p-300 ? Real(0) : y;
  };
  thread_local ExactSum sum;
  sum.clear();
  for (int i = 0; i < 3; ++i) {
    const Real p = scaled(a(i)), q = scaled(b(i));
    sum.addProduct(p, p, 1);
    sum.addProduct(q, q, 1);
    sum.addProduct(p, q, -2);
  }
  const Real u = scaled(r), v = scaled(s);
  sum.addProduct(u, u, -1);
  sum.addProduct(v, v, -1);
  sum.addProduct(u, v, -2);
  return sum;
}

}  // namespace

int gapSign(const Vector3& centerA, Real radiusA, const Vector3& centerB, Real radiusB) {
  const Real squared = (centerB - centerA).squaredNorm();
  const Real reach = radiusA + radiusB;
  const Real difference = squared - reach * reach;
  // Each coordinate of d is rounded once (twice that in the square), the square and the sums three
  // times more; the same for the reach. 16 half ulps of the larger term cover all of it.
  const Real largest = std::max(squared, reach * reach);
  if (largest > 1e-250 && largest < 1e300 && std::abs(difference) > 16 * 0x1p-53 * largest) {
    return difference > 0 ? 1 : -1;
  }
  int exponent = 0;
  return exactGap(centerA, radiusA, centerB, radiusB, exponent).sign();
}

Real preciseGap(const Vector3& centerA, Real radiusA, const Vector3& centerB, Real radiusB) {
  const Real distance = length(centerB - centerA);
  const Real plain = distance - (radiusA + radiusB);
  // Away from touching the plain difference loses at most ten bits, and the
  // exact one is thirty times slower.
  if (std::abs(plain) > 0x1p-10 * distance) return plain;
  int exponent = 0;
  const ExactSum& squares = exactGap(centerA, radiusA, centerB, radiusB, exponent);
  if (squares.sign() == 0) return 0;
  const Real sum = std::ldexp(distance, -exponent) +
                   (std::ldexp(radiusA, -exponent) + std::ldexp(radiusB, -exponent));
  return std::ldexp(squares.value() / sum, exponent);
}

}  // namespace carom
