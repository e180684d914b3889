#pragma once
// Which rotation is "turn along this vector"?
//
// A rotation vector points along the axis and is as long as the angle. Its quaternion is
// exp(v/2) = (cos a/2, v sin(a/2)/a) with a = |v|. The factor sin(a/2)/a is 0/0 for no rotation at
// all, so near zero it is taken from its series 1/2 - a^2/48 + a^4/3840 - ...
// Cutting that after a^2 leaves a^4/1920 of the factor: below 2^-11 rad that is 3e-17, a quarter of
// the rounding error, and cutting there needs no division. (The name: the map is the exponential
// series of the quaternion v/2; Grassia, Journal of Graphics Tools 3(3), 1998.)

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The unit quaternion that turns by |v| about v.
/// \param rotationVector axis times angle [rad, world]; zero is the identity
/// \return exp(v/2)
/// \throws InvalidInput if the vector is not finite, or too long for its length to be a double
/// \ingroup rotation
Quaternion quaternionExponential(const Vector3& rotationVector);

}  // namespace carom
