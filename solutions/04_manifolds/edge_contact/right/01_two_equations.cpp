// The two equations of the common perpendicular, written out.
#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/manifold/edge_contact.hpp"

namespace carom {

EdgeContact edgeContact(const Vector3& a0, const Vector3& a1, const Vector3& b0, const Vector3& b1,
                        const Vector3& axis) {
  const Vector3 u = a1 - a0;
  const Vector3 v = b1 - b0;
  const Real uu = u.dot(u), uv = u.dot(v), vv = v.dot(v);
  if (!(uu > 0 && vv > 0)) throw InvalidInput("an edge of no length");
  const auto limited = [](Real x) { return std::min(std::max(x, Real(0)), Real(1)); };
  EdgeContact c;
  c.normal = cross(u, v);
  if (c.normal.squaredNorm() <= 1e-16 * uu * vv) {
    // In parts of A's edge from a0.
    Real first = u.dot(b0 - a0) / uu, last = u.dot(b1 - a0) / uu;
    if (first > last) std::swap(first, last);
    c.s = (limited(first) + limited(last)) / 2;
    c.t = limited(v.dot(a0 + c.s * u - b0) / vv);
    c.normal = axis;
  } else {
    // u·(b0 + t v - a0 - s u) = 0 and v·(the same) = 0.
    const Real p = u.dot(b0 - a0), q = v.dot(b0 - a0);
    const Real determinant = uu * vv - uv * uv;
    c.s = limited((p * vv - q * uv) / determinant);
    c.t = limited((p * uv - q * uu) / determinant);
    c.normal.normalize();
    if (c.normal.dot(axis) < 0) c.normal *= -1;
  }
  c.pointA = (1 - c.s) * a0 + c.s * a1;
  c.pointB = (1 - c.t) * b0 + c.t * b1;
  c.separation = c.normal.dot(c.pointB - c.pointA);
  return c;
}

}  // namespace carom
