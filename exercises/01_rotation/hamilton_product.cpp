// Exercise 01.hamilton_product: the product of two quaternions.
// Check it with: ./course check 01.hamilton_product

#include "carom/rotation/hamilton_product.hpp"

#include "carom/core/todo.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  // Multiply out (q.w + q.x i + q.y j + q.z k)(r.w + r.x i + r.y j + r.z k) and sort by unit.
  static_cast<void>(q);
  static_cast<void>(r);
  return todo<Quaternion>("hamiltonProduct");
}

}  // namespace carom
