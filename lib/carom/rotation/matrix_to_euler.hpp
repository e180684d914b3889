#pragma once
// Which roll, pitch and yaw belong to a rotation matrix?
//
// Read the angles off the entries of R = Rz Ry Rx with arctangents of two arguments, which know the
// quadrant and lose no digits where arcsine and arccosine do. The trap is gimbal lock: towards
// pitch = +-pi/2 the entries that hold roll and yaw shrink to rounding noise. Roll may then be
// anything, but yaw must fit that roll. So yaw is not read from the entries where the books read
// it, but from R Rx(-roll) = Rz Ry, whose second column (-sin yaw, cos yaw, 0) never shrinks (after
// Shoemake, Graphics Gems IV, 1994, and Herter and Lott, Computers & Graphics 17, 1993). The matrix
// that is built again from the angles is then right everywhere, without a branch, and in the lock
// itself, where roll is arctan2(0, 0) = 0, yaw carries the rest. The price: a tiny yaw is right to
// an ulp of 1, not of itself.

#include "carom/rotation/euler_angles.hpp"

namespace carom {

/// Roll, pitch and yaw with R = Rz(yaw) Ry(pitch) Rx(roll). The matrix built again from them is
/// within 1e-15 of R everywhere; the angles themselves are within 8 ulp / cos(pitch) outside the
/// lock. At pitch = +-pi/2 exactly, roll is 0 and yaw carries the whole rest.
/// \param R rotation matrix, body to world [1]; may have drifted a little, see requireRotation()
/// \return roll and yaw in [-pi, pi], pitch in [-pi/2, pi/2] [rad]
/// \throws InvalidInput if R is not a rotation matrix
/// \erratum{3.6}
/// \ingroup rotation
EulerAngles matrixToEuler(const Matrix3& R);

}  // namespace carom
