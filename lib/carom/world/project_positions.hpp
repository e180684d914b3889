#pragma once
// How is an overlap taken away without making speed of it?
//
// Method: the bodies of an island are pushed apart by moving them, along the normals, by what is
// wanted and no more; velocities are not touched. Overlaps are taken away whole, contacts that
// carried and have come off by less than the tolerance are closed again. Deep overlaps come apart
// in steps. Where nothing is off by more than rounding nothing is done.
// Why not by velocity (Baumgarte 1972): the speed that pushes bodies apart stays with them.
// Source: nonlinear Gauss-Seidel; Cline and Pai 2003; split impulses: Guendelman and others 2003.
// Not handled: the best way out of a deep overlap of many bodies.

#include <span>

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Takes the overlap of a set of bodies away. \param state of the world, at the start of a step
/// \param bodies dynamic ones; they are moved \param pairs with fresh manifolds; the separations of
/// their points are changed \return whether anything was moved \ingroup world
bool projectPositions(WorldState& state, std::span<const Index> bodies,
                      std::span<const Index> pairs);

/// The same for gaps of another size. \param state of the world \param bodies dynamic ones; they
/// are moved \param pairs with fresh manifolds \param gap up to which a contact that carried is
/// closed again [m] \return whether anything was moved \ingroup world
bool projectPositions(WorldState& state, std::span<const Index> bodies,
                      std::span<const Index> pairs, Real gap);

/// The same at the end of a step for balls that touch: they went round each other on parabolas,
/// and the overlap that this leaves is closed while it is smallest. Repeated until nothing is off,
/// since separations of balls are no straight lines. Islands with other shapes, and those in which
/// no ball carries another, are left as they are. \param state of the world, all at the end
/// \param bodies dynamic ones \param pairs of these \param end of the step [s] \ingroup world
void projectRounds(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                   Real end);

}  // namespace carom::world
