#pragma once
// Several bodies glued together: what is the mass, centre and inertia of the whole?
//
// Method: volumes and masses add; the centre is the mean weighted by mass; each inertia is first
// moved to the common centre (parallel axes), then they add.
// Why: a compound of simple shapes is weighed without a mesh. A hole is a part of negative volume
// and mass.
// Source: equations 18 and 19, and the source text's Pacman (section 6.1).
// Not handled: parts that overlap count twice; parts turned against each other must be given in
// common axes (rotateInertia()).

#include <span>

#include "carom/core/real.hpp"
#include "carom/mass/mass_properties.hpp"

namespace carom {

/// The mass properties of bodies rigidly joined, all given in one frame.
/// \param parts at least one body, centre and inertia along common axes; negative volume and mass
/// for a hole
/// \return the whole: inertia about the common centre of mass
/// \throws InvalidInput if there are no parts or their total mass is not positive and finite
/// \source{19}
/// \erratum{4.10}
/// \ingroup mass
MassProperties combineBodies(std::span<const MassProperties> parts);

}  // namespace carom
