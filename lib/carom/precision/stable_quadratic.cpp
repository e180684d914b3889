#include "carom/precision/stable_quadratic.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/precision/difference_of_products.hpp"
#include "carom/precision/scaled_quadratic.hpp"

namespace carom {

QuadraticRoots stableQuadratic(Real a, Real b, Real c) {
  requireFinite(a, "a");
  requireFinite(b, "b");
  requireFinite(c, "c");
  if (a == 0 && b == 0) return {c == 0 ? RootCount::all : RootCount::none, 0, 0};
  if (a == 0) return {RootCount::one, -c / b, -c / b};

  const ScaledQuadratic s = scaledQuadratic(a, b, c);
  const auto unscaled = [&s](Real y) { return std::ldexp(y, s.exponent); };
  const Real discriminant = differenceOfProducts(s.b, s.b, 4 * s.a, s.c);
  if (discriminant < 0) return {};
  if (discriminant == 0) {
    const Real root = unscaled(-s.b / (2 * s.a));
    return {RootCount::one, root, root};
  }
  // -b and the square root get the same sign, so that nothing cancels.
  const Real q = -(s.b + std::copysign(std::sqrt(discriminant), s.b)) / 2;
  const Real larger = unscaled(q / s.a), smaller = unscaled(s.c / q);
  return {RootCount::two, std::min(larger, smaller), std::max(larger, smaller)};
}

}  // namespace carom
