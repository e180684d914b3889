#pragma once
// What stops two bodies that touch over one area and stick?
//
// The question as numbers: where every point presses and friction is within its cone nothing is
// limited, and the impulses are the solution of at most six linear equations: pressure as a plane
// over the points, and the rows of friction.
// Method: L D L^T without square roots. The answer is taken if no point would pull and the cone
// holds the friction; then it is the one that sweeps tend to.
// Why: a body on an edge or a tip trades its pressure with its friction, and sweeps gain a digit or
// less each; this costs as much as two of them.
// Not handled: slip, and points that let go: sweeps find those (solve_patches.hpp). Four points that
// have to part at speeds of no plane do so in the mean; the caller has to look.

#include <span>

#include "carom/solver/contact_patch.hpp"

namespace carom {

/// Solves a block alone, if it carries with all its points and does not slip.
/// \param bodies their velocities are changed; the impulses that the block holds have been applied
/// \param block its impulses are changed
/// \return whether it is solved; if not, nothing has changed \ingroup solver
bool holdBlock(std::span<MovingBody> bodies, ContactBlock& block);

}  // namespace carom
