#pragma once
// How is the first contact found without ever stepping past it?
//
// Method: if a gap of s closes at no more than u metres a second, nothing can happen for s/u
// seconds. Go there, look at the gap again, and so on, until it is as small as asked for.
// Why it is safe: no step is longer than the least time to contact. Why it ends: a gap that is not
// yet small makes a step of at least tolerance / u.
// How fast: if u is what the gap closes with, one step does. If u is twice that, each step halves
// the gap: thirty steps for nine digits.
// Source: Mirtich 1996. first_contact.hpp knows more about the motion and needs fewer steps.
// Not handled: what the gap is and how fast it closes at most; the caller says both.

#include <functional>

#include "carom/toi/time_of_impact.hpp"

namespace carom {

/// The first time at which a gap is as small as asked for.
/// \param gap distance of two bodies at a time; negative where they overlap [m]
/// \param fastest no gap closes faster than this, positive [m/s]
/// \param duration until when to look, zero or positive [s]
/// \param tolerance gap that counts as contact, positive [m]
/// \param maxSteps looks at the gap, after which it gives up
/// \return status, time, gap at that time, and steps; point and normal are not set. The time of a
///   hit is not later than the first contact, and its gap at most the tolerance
/// \throws InvalidInput if a number is not finite, `fastest` or the tolerance not positive, the
///   duration negative, there is no function, or maxSteps is not positive
/// \ingroup toi
TimeOfImpact conservativeAdvancement(const std::function<Real(Real time)>& gap, Real fastest,
                                     Real duration, Real tolerance, int maxSteps = 1000);

}  // namespace carom
