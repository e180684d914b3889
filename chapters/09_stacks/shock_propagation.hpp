#pragma once
// Can a tower be held up in one pass?
//
// Method: every body gets a level: how many contacts it is away from what cannot be moved. Level by
// level, from the ground up, the rows that end there are swept over; then the bodies of the level
// are taken for immovable, as if they were ground.
// Why it works for towers: what stands on ground needs no news from above.
// Source: Guendelman, Bridson and Fedkiw 2003, section 7.
// Not handled: that the upper bodies weigh on the lower ones. Those do not feel it, so a see-saw
// does not tip, and the impulses are not those of the answer.

#include <span>

#include "carom/solver/contact_row.hpp"

namespace carom {

/// Sweeps from the ground up, once, each level standing on the last one.
/// \param bodies their velocities are changed \param rows their impulses are changed
/// \param sweeps over the rows of each level; not negative
/// \throws InvalidInput if sweeps is negative
/// \ingroup solver
void shockPropagation(std::span<MovingBody> bodies, std::span<ContactRow> rows, int sweeps);

}  // namespace carom
