#pragma once
// Against which slip does friction at its limit act, if the slip changes within the step?
//
// Method: a block that does not slip at the start can only begin to: friction is against the slip
// at the end. One that slips has a mean slip over the step, and friction is against that. If
// friction could turn the slip round within the step it stops on the way, at a time that is
// computed later (stopTime()); until then friction is against the slip that was. Friction that
// could stop it a thousand times over stops it at once.
// Why in a file of its own: sweeps and the direct method have to obey one law.
// Source: chapter 5 for stop times; the trapezoidal rule for the mean.
// Not handled: slip that changes its direction much and comes to rest in the same step.

#include "carom/solver/contact_patch.hpp"

namespace carom {

/// What friction of a block is against. \ingroup solver
struct FrictionLaw {
  Vector3 before = Vector3::Zero();  ///< added to the slip at the end [m/s]
  bool given = false;  ///< friction is at its limit, against `before`, whatever the end is
};

/// Which law a block obeys. \param block prepared \param without slip at the end if this block had
/// no friction [m/s] \param limit largest friction [N s] \return the law \ingroup solver
FrictionLaw frictionLaw(const ContactBlock& block, const Vector3& without, Real limit);

}  // namespace carom
