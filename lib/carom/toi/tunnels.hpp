#pragma once
// Can a body jump over another one between two pictures?
//
// Method: seen from one of them, the other moves on by speed * dt from picture to picture. The two
// overlap while the difference of their places lies in an interval as long as both bodies together.
// A jump longer than that can clear the interval; a shorter one cannot.
// Why strictly longer: with a jump of just that length the bodies touch in both pictures, once in a
// lifetime, and touching counts.
// Source: section 8.3, whose cars of 3.6 m at 72 m/s move by 7.2 m in a tenth of a second, not by
// 6 m: with 6 m they would never miss each other.
// Not handled: other shapes than pieces of a line; and how deep an overlap is that is seen.

#include "carom/core/real.hpp"

namespace carom {

/// Whether two bodies on one line can pass through each other without overlapping in any picture.
/// \param lengthA of the first along the line, zero or positive [m]
/// \param lengthB of the second, zero or positive [m]
/// \param speed of one against the other, of any sign [m/s]
/// \param dt time between pictures, zero or positive [s]
/// \return true if there are starting places from which they do
/// \throws InvalidInput if a number is not finite, or a length or dt negative
/// \erratum{8.4}
/// \ingroup toi
bool tunnels(Real lengthA, Real lengthB, Real speed, Real dt);

}  // namespace carom
