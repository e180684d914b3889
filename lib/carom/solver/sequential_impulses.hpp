#pragma once
// How are many contacts solved, if one knows how to solve one?
//
// Method: one after the other, again and again. A visit gives a row the impulse after which it has
// its target speed; that spoils its neighbours a little, which are visited next. Each row remembers
// the sum of what it gave. The sum must not be negative, for a contact cannot pull; a single visit
// may well take something back.
// Why the sum and not the visit: what was pushed too much, because a neighbour had not been visited
// yet, would stay for good, and the bodies would fly apart.
// This is the method of Gauss and Seidel for A x = b, with limits; for frictionless contacts it
// converges to a solution of the complementarity problem (lcp_small.hpp).
// Source: Catto, GDC 2006; Moreau and Jean 1994 (as contact dynamics); Cottle, Pang and Stone 1992,
// section 5.2.
// Not handled: friction; knowing when to stop (solve_patches.hpp).

#include <span>

#include "carom/solver/contact_row.hpp"

namespace carom {

/// Visits all rows in order, several times.
/// \param bodies their velocities are changed; the impulses that rows hold have been applied
/// \param rows their impulses are changed
/// \param sweeps how many times all are visited, zero or more
/// \throws InvalidInput if sweeps is negative
/// \ingroup solver
void sequentialImpulses(std::span<MovingBody> bodies, std::span<ContactRow> rows, int sweeps);

}  // namespace carom
