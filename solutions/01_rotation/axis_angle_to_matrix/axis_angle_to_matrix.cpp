// Exercise 01.axis_angle_to_matrix: the matrix of an axis and an angle.
// Check it with: ./course check 01.axis_angle_to_matrix

#include "carom/rotation/axis_angle_to_matrix.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/length.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Matrix3 axisAngleToMatrix(const Vector3& axis, Real angle) {
  requireFinite(axis, "axis");
  requireFinite(angle, "angle");

  //# solution
  if (length(axis) == 0) throw InvalidInput("axis must not be zero: it has no direction");
  const Vector3 a = axis / length(axis);
  const Real s = sine(angle), c = cosine(angle);
  const Real halfSine = sine(angle / 2);
  const Real oneMinusCosine = 2 * halfSine * halfSine;

  Matrix3 R;
  for (int i = 0; i < 3; ++i) {
    const Vector3 e = Vector3::Unit(i);
    R.col(i) = c * e + s * cross(a, e) + oneMinusCosine * a.dot(e) * a;
  }
  return R;
  //# stub
  // Refuse the zero axis (throw InvalidInput("...")), bring the others to length 1, and fill the
  // columns R.col(0), R.col(1), R.col(2) with what becomes of the three unit vectors.
  //#| return todo<Matrix3>("axisAngleToMatrix");
  //# end
}

}  // namespace carom
