#pragma once
// Was the step good, and how long shall the next one be?
//
// Method: the tolerance is for the whole way, so each step gets of it what its time is of the whole
// time. An error that is more than that is too much, and the step has to be made again. The error
// of a step of a method of order p goes with the step to the power p + 1, and what is allowed with
// the step: so what is used of it goes with the power p, and its p-th root says how much longer the
// next step may be. No step is longer than what is left, and the last two are equal, lest the last
// one be a crumb.
// Why: rk_adaptive.hpp allows each step the same, however short it is. Then what a run is worth
// depends on how many steps it took; here it is known before.
// Source: Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, 1993, II.4, error
// per unit step; no growth after a step that failed: the same.
// Not handled: control with a memory (Gustafsson 1991, Söderlind 2003), and how the error is found.

#include "carom/motion/adaptive.hpp"

namespace carom {

/// Judges a step and proposes the next one.
/// \param done the step that was tried
/// \return whether its error is at most its share of the tolerance, and the next step: longer or
/// shorter by stepFactor() of the used part of the share, by a fifth if the error is no number, and
/// no longer if this step is good and the one before it was refused; cut at the end
/// \throws InvalidInput if requireUsable() does
/// \ingroup motion
StepChoice stepController(const StepTry& done);

}  // namespace carom
