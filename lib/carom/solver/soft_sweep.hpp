#pragma once
// One visit to each row, by rows that may be soft.
//
// Where bodies overlap, a row acts as the spring and damper that it is given; where there is still
// a gap, it allows the speed that just closes it by the end of the sub-step, and is rigid. With
// SoftContact{} it is rigid everywhere and does not care for overlap: what is left of a push then
// goes (relaxation).
// Source: Catto 2024 (Solver2D).
// Not handled: friction.

#include <span>

#include "carom/solver/contact_row.hpp"
#include "carom/solver/soft_contact.hpp"

namespace carom {

/// Overlap is not pushed out faster than this: a deep one, made by a program's mistake, must not
/// become an explosion [m/s]. \ingroup solver
inline constexpr Real kFastestPush = 3;

/// Visits all rows once.
/// \param bodies their velocities are changed; the impulses that rows hold have been applied
/// \param rows their impulses are changed; their targets are not used
/// \param soft how rows that overlap give way
/// \param dt length of the sub-step [s]
/// \ingroup solver
void softSweep(std::span<MovingBody> bodies, std::span<ContactRow> rows, const SoftContact& soft,
               Real dt);

}  // namespace carom
