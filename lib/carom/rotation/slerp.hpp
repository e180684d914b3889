#pragma once
// What lies between two orientations?
//
// The great arc on the sphere of unit quaternions, walked at constant speed (Shoemake, SIGGRAPH
// 1985). q and -q are the same rotation, so there is a short and a long way; the sign of the dot
// product tells which one b stands for, and the short one is taken. The angle between the two comes
// from 2 atan2(|a - b|, |a + b|) (Kahan), because acos of the dot product loses half the digits for
// orientations that are close to each other.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The orientation a fraction t of the short way from a to b.
/// \param a orientation at t = 0; any norm but zero
/// \param b orientation at t = 1; any norm but zero. Exactly half a turn from a, both ways are
///   equally long, and the one to b as it is given is taken
/// \param t fraction of the way [1]; below 0 and above 1 the same turn goes on
/// \return unit quaternion between them
/// \throws InvalidInput if a or b is zero or not finite, or t is not finite
/// \erratum{3.14}
/// \ingroup rotation
Quaternion slerp(const Quaternion& a, const Quaternion& b, Real t);

}  // namespace carom
