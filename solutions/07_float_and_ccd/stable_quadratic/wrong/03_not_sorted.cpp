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
  if (a == 0 && b == 0) return {c == 0 ? RootCount::all : RootCount::none, 0, 0};
  if (a == 0) return {RootCount::one, -c / b, -c / b};
  const Real d = differenceOfProducts(b, b, 4 * a, c);
  if (d < 0) return {};
  if (d == 0) return {RootCount::one, -b / (2 * a), -b / (2 * a)};
  const Real q = -(b + std::copysign(std::sqrt(d), b)) / 2;
  return {RootCount::two, q / a, c / q};
}

}  // namespace carom
