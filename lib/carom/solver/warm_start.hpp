#pragma once
// Where does the solver begin, if it solved nearly the same problem a moment ago?
//
// Method: with the answer of the last step. A row looks for the impulse that stood under its own
// name, takes it as its sum, and gives it to the bodies at once; a row with a new name begins with
// nothing. If this step is longer or shorter than the last one, the impulses are too.
// Why: what rests, rests with the same forces as before, so the first sweep finds nothing to do.
// The sweeps of many steps add up, and a few in each are enough.
// Source: Catto, GDC 2006; the names are those of chapter 4.
// Not handled: contacts whose normal has turned much since.

#include <span>

#include "carom/solver/contact_row.hpp"

namespace carom {

/// What is kept of a row until the next step. \ingroup solver
struct KeptImpulse {
  int name = 0;      ///< of the row
  Real impulse = 0;  ///< its sum at the end of the step [N s]
};

/// Gives each row, and its bodies, the impulse of the step before.
/// \param bodies their velocities are changed
/// \param rows their impulses are set, whatever they were
/// \param kept of the last step, in any order, each name once
/// \param ratio of the lengths of this step and the last one, zero or positive [1]
/// \throws InvalidInput if the ratio is negative or not finite
/// \ingroup solver
void warmStart(std::span<MovingBody> bodies, std::span<ContactRow> rows,
               std::span<const KeptImpulse> kept, Real ratio);

}  // namespace carom
