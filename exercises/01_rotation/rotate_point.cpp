// Exercise 01.rotate_point: where a quaternion takes a point.
// Check it with: ./course check 01.rotate_point

#include "carom/rotation/rotate_point.hpp"

#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/scaled_quaternion.hpp"

namespace carom {

Vector3 rotatePoint(const Quaternion& q, const Vector3& v) {
  // Refuse the zero quaternion (throw InvalidInput("...")), multiply from both sides, and mind the
  // length of q.
  return todo<Vector3>("rotatePoint");
}

}  // namespace carom
