#include "carom/rotation/quaternion_to_matrix.hpp"

#include "carom/rotation/scaled_quaternion.hpp"

namespace carom {

Matrix3 quaternionToMatrix(const Quaternion& q) {
  const Quaternion s = scaledQuaternion(q, "q");
  const Real k = 2 / squaredNorm(s);
  const Real kx = k * s.x, ky = k * s.y, kz = k * s.z;
  const Real wx = s.w * kx, wy = s.w * ky, wz = s.w * kz;
  const Real xx = s.x * kx, xy = s.x * ky, xz = s.x * kz;
  const Real yy = s.y * ky, yz = s.y * kz, zz = s.z * kz;
  Matrix3 R;
  // clang-format off
  R << 1 - (yy + zz), xy - wz,       xz + wy,
       xy + wz,       1 - (xx + zz), yz - wx,
       xz - wy,       yz + wx,       1 - (xx + yy);
  // clang-format on
  return R;
}

}  // namespace carom
