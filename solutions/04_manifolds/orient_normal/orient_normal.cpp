// Exercise 04.orient_normal: which of the two directions of an axis points from A to B?
// Check it with: ./course check 04.orient_normal

#include "carom/manifold/orient_normal.hpp"

#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"
#include "carom/detection/project.hpp"

namespace carom {

Vector3 orientNormal(const Vector3& axis, std::span<const Vector3> a, std::span<const Vector3> b) {
  // Given: what is no body is refused.
  if (a.empty() || b.empty()) {
    throw InvalidInput("orientNormal: each body must have at least one corner");
  }
  //# solution
  const Interval onA = project(a, axis);
  const Interval onB = project(b, axis);
  const Real forwards = onA.high - onB.low;   // how far B has to go along the axis
  const Real backwards = onB.high - onA.low;  // and against it
  return forwards <= backwards ? axis : Vector3(-axis);
  //# stub
  // project(a, axis) is the shadow of A on the axis: an interval from .low to .high.
  //#| return todo<Vector3>("orientNormal");
  //# end
}

}  // namespace carom
