#pragma once
// Which quaternion turns about a given axis by a given angle?
//
// (cos w/2, a sin w/2) for a unit axis a. Half the angle, because rotating a point multiplies by
// the quaternion twice, once from each side. The source does not say that the axis must have length
// 1, and its example writes 180 degrees where the formula wants pi; here the axis is normalised,
// and angles are radians everywhere.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The unit quaternion that turns by an angle about an axis.
/// \param axis direction of the axis [any unit, world]; its length does not matter
/// \param angle [rad], any size; a whole turn more gives the other sign, which is the same rotation
/// \return (cos angle/2, unit axis * sin angle/2)
/// \throws InvalidInput if the axis is zero or not finite, or the angle is not finite
/// \source{3,7}
/// \erratum{3.10,3.11}
/// \ingroup rotation
Quaternion axisAngleToQuaternion(const Vector3& axis, Real angle);

}  // namespace carom
