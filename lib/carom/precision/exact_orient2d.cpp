#include "carom/precision/exact_orient2d.hpp"

#include "carom/precision/difference_of_products.hpp"
#include "carom/precision/exact_sum.hpp"
#include "carom/precision/scaled_points.hpp"

namespace carom {
namespace {

int signOf(Real value) {
  return (value > 0) - (value < 0);
}

void addProduct(ExactSum& sum, Real a, Real b) {
  const TwoProduct p = twoProduct(a, b);
  sum.add(p.error);
  sum.add(p.product);
}

}  // namespace

int exactOrient2d(const Vector2& a, const Vector2& b, const Vector2& c) {
  // Coordinates are multiples of 2^-503 below 2^450: no digit of two of them multiplied is lost.
  std::array<Vector2, 3> points{a, b, c};
  detail::scaleTo(points, 450, 900);
  const auto& [p, q, r] = points;

  const DoubleDouble px = exactDifference(p.x(), r.x()), py = exactDifference(p.y(), r.y());
  const DoubleDouble qx = exactDifference(q.x(), r.x()), qy = exactDifference(q.y(), r.y());
  if (px.low == 0 && py.low == 0 && qx.low == 0 && qy.low == 0) {
    return signOf(differenceOfProducts(px.high, qy.high, py.high, qx.high));
  }
  ExactSum sum;
  addProduct(sum, p.x(), q.y());
  addProduct(sum, -p.y(), q.x());
  addProduct(sum, q.x(), r.y());
  addProduct(sum, -q.y(), r.x());
  addProduct(sum, r.x(), p.y());
  addProduct(sum, -r.y(), p.x());
  return sum.sign();
}

}  // namespace carom
