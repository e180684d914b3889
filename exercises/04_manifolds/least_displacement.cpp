// Exercise 04.least_displacement: the shortest way out of an overlap.
// Check it with: ./course check 04.least_displacement

#include "carom/manifold/least_displacement.hpp"

#include <limits>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"
#include "carom/core/todo.hpp"
#include "carom/detection/project.hpp"

namespace carom {

LeastDisplacement leastDisplacement(std::span<const Vector3> axes, std::span<const Vector3> a,
                                    std::span<const Vector3> b) {
  // Given: what cannot be answered is refused.
  if (axes.empty() || a.empty() || b.empty()) {
    throw InvalidInput("leastDisplacement: there must be an axis and a corner of each body");
  }
  for (const Vector3& axis : axes) requirePositive(length(axis), "length of an axis");
  LeastDisplacement best;
  best.separation = -std::numeric_limits<Real>::infinity();
  // project(a, axis) is the shadow of A, in metres, whatever the length of the axis.
  return todo<LeastDisplacement>("leastDisplacement");
}

}  // namespace carom
