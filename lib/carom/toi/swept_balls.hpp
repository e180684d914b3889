#pragma once
// When do two balls meet that move in straight lines?
//
// Method: seen from A, the centre of B moves from p along v, and they touch when it is R = rA + rB
// away: |p + v t|^2 = R^2. With a = v.v, b = p.v and c = p.p - R^2 the first root is
//   t = c / (-b + sqrt(b^2 - a c)).
// Why this form: the textbook's (-b - sqrt(...)) / a takes two nearly equal numbers from each other
// when the balls are close already.
// Whether they meet at all is the sign of b^2 - a c, which is the same as a R^2 - |p x v|^2: a hit
// that grazes by 1e-12 m has lost all its digits in the first form and keeps them in the second.
// Source: section 8.3; Ericson, Real-Time Collision Detection, 2005, 5.5.5.
// Not handled: balls on curves (first_contact.hpp).

#include "carom/toi/moving_ball.hpp"
#include "carom/toi/time_of_impact.hpp"

namespace carom {

/// The first contact of two balls in straight motion. Touching counts; balls that touch at the
/// start and part are a hit at time zero.
/// \param a the first \param b the second
/// \param duration until when to look, zero or positive [s]
/// \return status, time, point, normal from A to B, and gap at that time. Whether a graze is a hit
///   is decided exactly for the relative place and velocity as rounded to doubles
/// \throws InvalidInput if a number is not finite or above 1e40 in size, or a radius or the duration
///   negative
/// \ingroup toi
TimeOfImpact sweptBalls(const MovingBall& a, const MovingBall& b, Real duration);

}  // namespace carom
