#pragma once
// How far apart are two orientations?
//
// The turn from a to b is a* b, and its angle is 2 atan2(|(x, y, z)|, |w|). The absolute value of w
// picks the shorter of the two ways, since q and -q are the same rotation. 2 acos(|w|) is the same
// angle on paper, but w is 1 to the last digit for every angle below 1e-8, so it cannot measure the
// errors of a good method. The arctangent needs no quaternion of length 1 either: a common factor
// of its arguments cancels.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The angle of the shortest turn that takes one orientation to another.
/// \param a orientation; any norm but zero
/// \param b orientation in the same frame; any norm but zero
/// \return angle from 0 to pi [rad], right to a few ulp of 1e-16 and of itself; the same when a and
/// b
///   are exchanged
/// \throws InvalidInput if a or b is zero or not finite
/// \erratum{3.14}
/// \ingroup rotation
Real angleBetween(const Quaternion& a, const Quaternion& b);

}  // namespace carom
