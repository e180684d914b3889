#pragma once
// Which matrix belongs to roll, pitch and yaw?
//
// R = Rz(yaw) Ry(pitch) Rx(roll), multiplied out. The first rotation stands at the right, next to
// the point that it turns. Multiplied out rather than as three products because each entry then
// carries at most two roundings per term. Source: equations 1 and 2; the entry (1,1) of equation 2
// is wrong.

#include "carom/rotation/euler_angles.hpp"

namespace carom {

/// The rotation matrix R = Rz(yaw) Ry(pitch) Rx(roll). Entries are right to 4e-16. The source's
/// equation 2 has cos(yaw) sin(pitch) where cos(yaw) cos(pitch) belongs: at zero angles its first
/// row is zero.
/// \param angles roll, pitch, yaw [rad, world axes], any size
/// \return 3x3 matrix that turns coordinates in the body into coordinates in the world [1]
/// \throws InvalidInput if an angle is not finite
/// \source{1,2}
/// \erratum{3.8}
/// \ingroup rotation
Matrix3 eulerToMatrix(const EulerAngles& angles);

}  // namespace carom
