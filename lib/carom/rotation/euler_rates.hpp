#pragma once
// Which angular velocity do changing Euler angles make?
//
// Roll turns about an axis that pitch and yaw have moved, pitch about one that yaw has moved, yaw
// about z. The three axes are the columns of a matrix. Its determinant is cos(pitch): at +-pi/2 the
// axes of roll and yaw coincide, and no rates of the angles make a turn about the third direction.
// That is gimbal lock; it is a defect of the three angles, not of the body.

#include "carom/rotation/euler_angles.hpp"

namespace carom {

/// The matrix E with omega = E (d roll/dt, d pitch/dt, d yaw/dt). Its determinant is cos(pitch).
/// \param angles roll, pitch, yaw [rad]
/// \return 3x3 matrix; its columns are the axes of roll, pitch and yaw [1, world]
/// \throws InvalidInput if an angle is not finite
/// \erratum{3.6}
/// \ingroup rotation
Matrix3 eulerRateMatrix(const EulerAngles& angles);

}  // namespace carom
