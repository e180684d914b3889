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
  // {RootCount::two, x, y} is a QuadraticRoots. std::copysign(x, b) is |x| with the sign of b;
  // std::sqrt, std::min and std::max are there too.
  return todo<QuadraticRoots>("stableQuadratic");
}

}  // namespace carom
