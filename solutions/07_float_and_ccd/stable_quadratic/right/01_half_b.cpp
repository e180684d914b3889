#include "carom/precision/stable_quadratic.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "carom/core/checks.hpp"
#include "carom/precision/difference_of_products.hpp"

namespace carom {

QuadraticRoots stableQuadratic(Real a, Real b, Real c) {
  requireFinite(a, "a");
  requireFinite(b, "b");
  requireFinite(c, "c");
  if (a == 0) {
    if (b == 0) return {c == 0 ? RootCount::all : RootCount::none, 0, 0};
    const Real x = -c / b;
    return {RootCount::one, x, x};
  }
  // a x^2 - 2 h x + c with h = -b/2: a quarter of the discriminant, no fours and twos.
  const Real h = -b / 2;
  const Real d = differenceOfProducts(h, h, a, c);
  if (d < 0) return {};
  if (d == 0) return {RootCount::one, h / a, h / a};
  const Real sum = h < 0 ? h - std::sqrt(d) : h + std::sqrt(d);
  Real x = sum / a, y = c / sum;
  if (x > y) std::swap(x, y);
  return {RootCount::two, x, y};
}

}  // namespace carom
