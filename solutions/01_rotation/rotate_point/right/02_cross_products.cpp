// Multiplied out: v + 2 u x (u x v + w v) / |q|^2.
#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "carom/rotation/scaled_quaternion.hpp"

namespace carom {

Vector3 rotatePoint(const Quaternion& q, const Vector3& v) {
  if (squaredNorm(q) == 0) throw InvalidInput("q is zero");
  const Vector3 u(q.x, q.y, q.z);
  const Vector3 t = cross(u, v) + q.w * v;
  return v + 2 / squaredNorm(q) * cross(u, t);
}

}  // namespace carom
