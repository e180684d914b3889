#pragma once
// What does a contact point remember of the last step?
//
// Method: each new point looks for the old point of the same name, and takes over its impulse; a
// point that was not there before starts from zero.
// Why by name: clipping may begin anywhere, and points come and go, so the place in the list says
// nothing about which point it is.
// Source: Catto, GDC 2006 (warm starting).
// Not handled: what the impulses are for; chapter 9 starts its iteration from them.

#include <cstdint>
#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// Hands the impulses of the last step to the contact points of this one.
/// \param oldIds names of the points of the last step, no two equal, see contactIds()
/// \param oldImpulses their impulses along the normal [N s]
/// \param newIds names of the points of this step, no two equal
/// \return one impulse per new point [N s]; zero for a point that was not there before
/// \throws InvalidInput if there are not as many old impulses as old names
/// \ingroup manifold
std::vector<Real> carryImpulses(std::span<const std::uint32_t> oldIds,
                                std::span<const Real> oldImpulses,
                                std::span<const std::uint32_t> newIds);

}  // namespace carom
