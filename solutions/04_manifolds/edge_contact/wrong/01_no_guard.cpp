// Exercise 04.edge_contact: where do two edges touch, and in which direction?
// Check it with: ./course check 04.edge_contact

#include "carom/manifold/edge_contact.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"

namespace carom {

EdgeContact edgeContact(const Vector3& a0, const Vector3& a1, const Vector3& b0, const Vector3& b1,
                        const Vector3& axis) {
  const Vector3 u = a1 - a0;
  const Vector3 v = b1 - b0;
  [[maybe_unused]] const Vector3 between = b0 - a0;
  const Real uu = u.squaredNorm();
  const Real vv = v.squaredNorm();
  if (!(uu > 0) || !(vv > 0)) throw InvalidInput("edgeContact: an edge has no length");
  [[maybe_unused]] constexpr Real kParallel = 1e-16;
  EdgeContact contact;
  const Vector3 perpendicular = cross(u, v);
  const Real square = perpendicular.squaredNorm();  // |u|² |v|² sin²
  if (square >= 0) {
    // between + t v - s u must be parallel to u x v.
    contact.s = std::clamp(cross(between, v).dot(perpendicular) / square, 0.0, 1.0);
    contact.t = std::clamp(cross(between, u).dot(perpendicular) / square, 0.0, 1.0);
    contact.normal = perpendicular / std::sqrt(square);
    if (contact.normal.dot(axis) < 0) contact.normal = -contact.normal;
  } else {
    // Both ends of B's edge, measured along A's: the common part is the overlap with [0, 1].
    const Real start = between.dot(u) / uu;
    const Real end = (between + v).dot(u) / uu;
    const Real low = std::clamp(std::min(start, end), 0.0, 1.0);
    const Real high = std::clamp(std::max(start, end), 0.0, 1.0);
    contact.s = (low + high) / 2;
    contact.t = std::clamp((contact.s * u - between).dot(v) / vv, 0.0, 1.0);
    contact.normal = axis;
  }
  contact.pointA = a0 + contact.s * u;
  contact.pointB = b0 + contact.t * v;
  contact.separation = (contact.pointB - contact.pointA).dot(contact.normal);
  return contact;
}

}  // namespace carom
