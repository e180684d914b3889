// Exercise 04.edge_contact: where do two edges touch, and in which direction?
// Check it with: ./course check 04.edge_contact

#include "carom/manifold/edge_contact.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"

namespace carom {

EdgeContact edgeContact(const Vector3& a0, const Vector3& a1, const Vector3& b0, const Vector3& b1,
                        const Vector3& axis) {
  const Vector3 u = a1 - a0;
  const Vector3 v = b1 - b0;
  [[maybe_unused]] const Vector3 between = b0 - a0;
  const Real uu = u.squaredNorm();
  const Real vv = v.squaredNorm();
  // Given: an edge without length is refused.
  if (!(uu > 0) || !(vv > 0)) throw InvalidInput("edgeContact: an edge has no length");
  // Given: edges are parallel if the squared sine of their angle is not above this.
  [[maybe_unused]] constexpr Real kParallel = 1e-16;
  EdgeContact contact;
  // u and v run along the edges, `between` from a0 to b0. std::clamp(x, 0.0, 1.0) limits a number.
  return todo<EdgeContact>("edgeContact");
}

}  // namespace carom
