#include "carom/precision/in_circle.hpp"

#include "carom/precision/double_double.hpp"
#include "carom/precision/exact_sum.hpp"
#include "carom/precision/scaled_points.hpp"

namespace carom {
namespace {

// a b c d, where each factor is exactly the sum of two doubles; the low parts are mostly zero.
void addProduct(ExactSum& sum, const std::array<DoubleDouble, 4>& factors) {
  for (int parts = 0; parts < 16; ++parts) {
    std::array<Real, 4> f{};
    bool zero = false;
    for (std::size_t i = 0; i < 4; ++i) {
      f[i] = (parts >> i) & 1 ? factors[i].low : factors[i].high;
      zero = zero || f[i] == 0;
    }
    if (!zero) sum.addProduct(f[0], f[1], f[2], f[3]);
  }
}

// The sign by numbers of twice the digits: settles all but points on the circle. 0: it does not.
int doubleDoubleSign(const std::array<Vector2, 4>& points, Real size) {
  if (!(size > 1e-150 && size < 1e300)) return 0;  // parts of products could get lost
  const Vector2& d = points[3];
  std::array<std::array<DoubleDouble, 2>, 3> v;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = {exactDifference(points[i].x(), d.x()), exactDifference(points[i].y(), d.y())};
  }
  DoubleDouble value;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &p = v[i], &q = v[(i + 1) % 3], &r = v[(i + 2) % 3];
    value += (p[0] * p[0] + p[1] * p[1]) * (q[0] * r[1] - r[0] * q[1]);
  }
  // Five operations deep, each within 7 * 2^-106 of the terms; this is a hundred times as much.
  if (std::abs(value.high) <= 0x1p-95 * size) return 0;
  return value.high > 0 ? 1 : -1;
}

int exactSign(std::array<Vector2, 4> points) {
  // Coordinates are multiples of 2^-253 below 2^240: no digit of four of them multiplied is lost.
  detail::scaleTo(points, 240, 440);
  const Vector2& d = points[3];
  std::array<std::array<DoubleDouble, 2>, 3> v;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = {exactDifference(points[i].x(), d.x()), exactDifference(points[i].y(), d.y())};
  }
  ExactSum sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &p = v[i], &q = v[(i + 1) % 3], &r = v[(i + 2) % 3];
    for (std::size_t k = 0; k < 2; ++k) {
      addProduct(sum, {p[k], p[k], q[0], r[1]});
      addProduct(sum, {p[k], p[k], -r[0], q[1]});
    }
  }
  return sum.sign();
}

// Not inlined: its many registers would be saved on the way through the filter too.
[[gnu::noinline]] int carefulSign(const std::array<Vector2, 4>& points, Real size) {
  const int sign = doubleDoubleSign(points, size);
  return sign != 0 ? sign : exactSign(points);
}

}  // namespace

FilteredSign inCircle(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  const Vector2 u = a - d, v = b - d, w = c - d;
  const auto cross = [](const Vector2& p, const Vector2& q) {
    return p.x() * q.y() - q.x() * p.y();
  };
  const auto crossSize = [](const Vector2& p, const Vector2& q) {
    return std::abs(p.x() * q.y()) + std::abs(q.x() * p.y());
  };
  const Real uu = u.squaredNorm(), vv = v.squaredNorm(), ww = w.squaredNorm();
  const Real value = uu * cross(v, w) + vv * cross(w, u) + ww * cross(u, v);
  const Real size = uu * crossSize(v, w) + vv * crossSize(w, u) + ww * crossSize(u, v);
  // Shewchuk's (10 + 96 eps) eps, eps = 2^-53. Underflow costs the factors less than 1e-322, and
  // times the other factor, if that is below 1e100, less than kUnderflow.
  constexpr Real kErrorBound = 10.000000000000011 * 0x1p-53, kUnderflow = 1e-200;
  if (std::abs(value) > kErrorBound * size + kUnderflow && uu + vv + ww < 1e100) {
    return {value > 0 ? 1 : -1, true};
  }
  return {carefulSign({a, b, c, d}, size), false};
}

}  // namespace carom
