// Exercise 02.parallel_axis: the inertia about a point that is not the centre of mass.
// Check it with: ./course check 02.parallel_axis

#include "carom/mass/parallel_axis.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Matrix3 parallelAxis(const Matrix3& inertiaAboutCenter, Real mass, const Vector3& offset) {
  // Given: what is no number is refused.
  requireFinite(inertiaAboutCenter, "inertiaAboutCenter");
  requireFinite(mass, "mass");
  requireFinite(offset, "offset");
  // d.dot(d) is |d|², d * d.transpose() is d dᵀ, and Matrix3::Identity() is E.
  return todo<Matrix3>("parallelAxis");
}

}  // namespace carom
