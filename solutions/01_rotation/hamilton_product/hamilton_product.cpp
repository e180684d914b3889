// Exercise 01.hamilton_product: the product of two quaternions.
// Check it with: ./course check 01.hamilton_product

#include "carom/rotation/hamilton_product.hpp"

#include "carom/core/todo.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  //# solution
  return {q.w * r.w - q.x * r.x - q.y * r.y - q.z * r.z,   //
          q.w * r.x + q.x * r.w + q.y * r.z - q.z * r.y,   //
          q.w * r.y - q.x * r.z + q.y * r.w + q.z * r.x,   //
          q.w * r.z + q.x * r.y - q.y * r.x + q.z * r.w};
  //# stub
  // Multiply out (q.w + q.x i + q.y j + q.z k)(r.w + r.x i + r.y j + r.z k) and sort by unit.
  //#| static_cast<void>(q);
  //#| static_cast<void>(r);
  //#| return todo<Quaternion>("hamiltonProduct");
  //# end
}

}  // namespace carom
