#pragma once
// The quaternion of a matrix.
//
// The trace gives w, and with w the rest follows: unless w is nearly 0, which is half a turn, where
// that road divides noise by noise. Shepperd (Journal of Guidance and Control 1, 1978): of w, x, y
// and z, start from the one that is certain to be large, at least 1/2.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The unit quaternion of a rotation matrix, with w >= 0.
/// \param R rotation matrix, body to world [1]; may have drifted a little, see requireRotation()
/// \return unit quaternion, body to world, components right to about 2e-16 if R is
/// \throws InvalidInput if R is not a rotation matrix
/// \ingroup rotation
Quaternion matrixToQuaternion(const Matrix3& R);

}  // namespace carom
