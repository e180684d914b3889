#pragma once
// When does a thrown ball touch a floor?
//
// Method: only the height above the plane counts, and it is a parabola in time:
//   h0 - r + v t + a t^2 / 2 = 0,
// with v and a along the plane's normal. The first root that is not in the past is wanted. A plane
// has no edges, so there is nothing else to ask.
// Why the root as 2c / (-v + sqrt(v^2 - 2 a c)): it holds for a = 0, and nothing cancels when the
// ball falls. When it rises first the other root is the one wanted.
// Source: equation 1 in the direction of the normal; Ericson 2005, 5.5.3.
// Not handled: floors that move (subtract their velocity first).

#include "carom/detection/shapes.hpp"
#include "carom/toi/moving_ball.hpp"
#include "carom/toi/time_of_impact.hpp"

namespace carom {

/// The first contact of a thrown ball with the plane of a half-space at rest. Touching counts.
/// \param ball at time zero
/// \param acceleration steady, for example that of gravity [m/s^2, world]
/// \param plane at rest in the world, its normal of length one
/// \param duration until when to look, zero or positive [s]
/// \return status, time, point, normal from the ball into the plane, and gap at that time
/// \throws InvalidInput if a number is not finite or above 1e40 in size, the radius or the duration
///   negative
/// \ingroup toi
TimeOfImpact sweptBallPlane(const MovingBall& ball, const Vector3& acceleration,
                            const HalfSpace& plane, Real duration);

}  // namespace carom
