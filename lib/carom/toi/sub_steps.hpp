#pragma once
// Is it enough to look more often?
//
// Method: cut the step into parts, look at the bodies at the end of each, and where two overlap,
// halve the part in which they began to, until the moment is known.
// The source's rule: "locally a little smaller steps where two bodies could teleport through each
// other". How small: if no point of one moves faster than u against the other, a gap changes by at
// most u h / 2 between two looks that are h apart and the nearer of them. So with
//   h <= 2 depth / u
// no overlap deeper than `depth` goes unseen. Who passes through a wall overlaps it by the lesser
// of both thicknesses at some moment; half of that as `depth`, and nobody does. And bodies whose
// gap is larger than u times the step need no look at all.
// Why not: a corner that only clips another is missed if the clip is shallower, and a wall of a
// millimetre asks a bullet for thousands of looks. first_contact.hpp misses nothing, for less.
// Source: section 8.3.
// Not handled: half-spaces that turn, and a pair of them.

#include "carom/detection/shapes.hpp"
#include "carom/toi/sweep.hpp"
#include "carom/toi/time_of_impact.hpp"

namespace carom {

/// How many parts a step must have so that no overlap deeper than `depth` goes unseen.
/// \param a usable shape of A \param A its motion
/// \param b usable shape of B \param B its motion
/// \param duration of the step, zero or positive [s]
/// \param depth of the overlap that must be seen, positive [m]
/// \return number of parts; zero if they cannot meet in this step
/// \throws InvalidInput if a number is not finite, a pose not rigid, the duration negative, the
///   depth not positive, a half-space turns or both are half-spaces, or more than 2^31 - 1 parts
///   are needed
/// \ingroup toi
int subStepsFor(const Shape& a, const Sweep& A, const Shape& b, const Sweep& B, Real duration,
                Real depth);

/// The first contact that looking at the end of equal parts of a step finds. It may miss one, and
/// the time may be that of a later one; what is found is right to the tolerance.
/// \param a usable shape of A \param A its motion
/// \param b usable shape of B \param B its motion
/// \param duration of the step, zero or positive [s]
/// \param parts of equal length, positive
/// \param tolerance gap that counts as contact, positive [m]
/// \return status, time, point, normal, gap, and looks in `steps`
/// \throws InvalidInput if a number is not finite, a pose not rigid, the duration negative, or the
///   tolerance or the number of parts not positive
/// \ingroup toi
TimeOfImpact contactBySubSteps(const Shape& a, const Sweep& A, const Shape& b, const Sweep& B,
                               Real duration, int parts, Real tolerance);

}  // namespace carom
