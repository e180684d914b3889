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
  //# solution
  const Quaternion s = scaledQuaternion(q, "q");  // refuses zero
  const Quaternion point{0, v.x(), v.y(), v.z()};
  const Quaternion turned = hamiltonProduct(hamiltonProduct(s, point), conjugate(s));
  return Vector3(turned.x, turned.y, turned.z) / squaredNorm(s);
  //# stub
  // Refuse the zero quaternion (throw InvalidInput("...")), multiply from both sides, and mind the
  // length of q.
  //#| return todo<Vector3>("rotatePoint");
  //# end
}

}  // namespace carom
