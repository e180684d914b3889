#include "carom/rotation/matrix_to_quaternion.hpp"

#include <algorithm>

#include "carom/rotation/renormalize.hpp"
#include "carom/rotation/require_rotation.hpp"

namespace carom {

Quaternion matrixToQuaternion(const Matrix3& R) {
  requireRotation(R, "R");

  // 4 w^2, 4 x^2, 4 y^2, 4 z^2. Every entry of R is a sum of two of the ten products of components,
  // so each branch below is 4 q times the component that it starts from.
  const Real ww = 1 + R(0, 0) + R(1, 1) + R(2, 2);
  const Real xx = 1 + R(0, 0) - R(1, 1) - R(2, 2);
  const Real yy = 1 - R(0, 0) + R(1, 1) - R(2, 2);
  const Real zz = 1 - R(0, 0) - R(1, 1) + R(2, 2);
  const Real largest = std::max({ww, xx, yy, zz});

  const Real wx = R(2, 1) - R(1, 2), wy = R(0, 2) - R(2, 0), wz = R(1, 0) - R(0, 1);
  const Real xy = R(1, 0) + R(0, 1), xz = R(0, 2) + R(2, 0), yz = R(2, 1) + R(1, 2);
  Quaternion q;
  if (largest == ww) {
    q = {ww, wx, wy, wz};
  } else if (largest == xx) {
    q = {wx, xx, xy, xz};
  } else if (largest == yy) {
    q = {wy, xy, yy, yz};
  } else {
    q = {wz, xz, yz, zz};
  }
  if (q.w < 0) q = {-q.w, -q.x, -q.y, -q.z};
  return renormalize(q);
}

}  // namespace carom
