// Exercise 07.stable_quadratic: where is a parabola zero, to the last digits?
// Check it with: ./course check 07.stable_quadratic

#include "carom/precision/stable_quadratic.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"
#include "carom/precision/difference_of_products.hpp"

namespace carom {

QuadraticRoots stableQuadratic(Real a, Real b, Real c) {
  // Given: what is not a number is refused.
  requireFinite(a, "a");
  requireFinite(b, "b");
  requireFinite(c, "c");
  //# solution
  if (a == 0 && b == 0) return {c == 0 ? RootCount::all : RootCount::none, 0, 0};
  if (a == 0) return {RootCount::one, -c / b, -c / b};
  const Real discriminant = differenceOfProducts(b, b, 4 * a, c);
  if (discriminant < 0) return {RootCount::none, 0, 0};
  if (discriminant == 0) return {RootCount::one, -b / (2 * a), -b / (2 * a)};
  const Real q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
  return {RootCount::two, std::min(q / a, c / q), std::max(q / a, c / q)};
  //# stub
  // {RootCount::two, x, y} is a QuadraticRoots. std::copysign(x, b) is |x| with the sign of b;
  // std::sqrt, std::min and std::max are there too.
  //#| return todo<QuadraticRoots>("stableQuadratic");
  //# end
}

}  // namespace carom
