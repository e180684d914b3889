// Lets functions of the library do it: they know unit quaternions, and only up to sign.
#include "carom/rotation/hamilton_product.hpp"

#include "carom/rotation/matrix_to_quaternion.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  return matrixToQuaternion(quaternionToMatrix(q) * quaternionToMatrix(r));
}

}  // namespace carom
