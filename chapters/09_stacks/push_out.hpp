#pragma once
// How are bodies that overlap moved apart without becoming faster?
//
// Method: a second set of velocities, for this purpose alone (pseudo-velocities, split impulses).
// All begin at rest, the rows ask for a part of the overlap as a "speed", the solver of this chapter
// finds the rest; then the bodies are moved by those velocities, which are thrown away.
// Why: a real velocity that takes overlap away stays when the overlap is gone, and the body hops.
// Source: Guendelman, Bridson and Fedkiw 2003; Catto, GDC 2006.
// Not handled: rotations so large that the rows would change on the way.

#include <span>
#include <vector>

#include "carom/solver/contact_row.hpp"

namespace carom {

/// How far bodies have to be moved so that they overlap less.
/// \param bodies masses; their velocities do not matter
/// \param rows separations; their impulses and targets do not matter
/// \param share of each overlap that is taken away, from 0 to 1 [1]
/// \param sweeps over the rows, zero or more
/// \return for each body how far to move it [m] and turn it [rad]
/// \throws InvalidInput if share or sweeps is out of its range
/// \ingroup solver
std::vector<Velocity> pushOut(std::span<const MovingBody> bodies, std::span<const ContactRow> rows,
                              Real share, int sweeps);

}  // namespace carom
