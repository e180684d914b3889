// Exercise 02.box_inertia: the inertia tensor of a box.
// Check it with: ./course check 02.box_inertia

#include "carom/mass/box_inertia.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Matrix3 boxInertia(Real mass, const Vector3& size) {
  // Given: what is no box is refused.
  requirePositive(mass, "mass");
  for (int k = 0; k < 3; ++k) requirePositive(size[k], "size");
  //# solution
  const Real xx = size.x() * size.x();
  const Real yy = size.y() * size.y();
  const Real zz = size.z() * size.z();

  Matrix3 inertia = Matrix3::Zero();
  inertia(0, 0) = mass * (yy + zz) / 12;
  inertia(1, 1) = mass * (xx + zz) / 12;
  inertia(2, 2) = mass * (xx + yy) / 12;
  return inertia;
  //# stub
  // Which two edges count for the axis x? Matrix3::Zero() is a matrix of zeros to begin with.
  //#| return todo<Matrix3>("boxInertia");
  //# end
}

}  // namespace carom
