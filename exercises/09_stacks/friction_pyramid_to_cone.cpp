// Exercise 09.friction_pyramid_to_cone: friction within a cone
// Check it with: ./course check 09.friction_pyramid_to_cone

#include "carom/solver/friction_pyramid_to_cone.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Vector2 frictionPyramidToCone(const Vector2& friction, const Vector2& slip, Real mass, Real limit) {
  requireNonNegative(mass, "mass");
  requireNonNegative(limit, "limit");
  // friction is the sum so far, slip what is left with it. v.norm() is the length of a vector.
  // A pyramid would limit x and y each by itself.
  return todo<Vector2>("frictionPyramidToCone");
}

}  // namespace carom
