#pragma once
// About which axis, and how far, does a quaternion turn?
//
// The angle is 2 atan2(|(x, y, z)|, w), which is accurate for small and large angles alike; 2
// acos(w) returns 0 for an angle of 1e-8, because w is then 1 to the last bit. q and -q are the
// same rotation; of their two vectors the shorter one is returned, at most pi long.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The rotation vector of q, the inverse of quaternionExponential() up to half a turn.
/// \param q rotation; any norm but zero
/// \return axis times angle [rad, world], length at most pi; at half a turn its sign is that of
///   (x, y, z) if w is +0 or positive
/// \throws InvalidInput if q is zero or not finite
/// \erratum{3.14}
/// \ingroup rotation
Vector3 quaternionLogarithm(const Quaternion& q);

}  // namespace carom
