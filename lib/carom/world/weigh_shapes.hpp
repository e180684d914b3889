#pragma once
// What does a body weigh that is made of shapes?
//
// Method: closed forms of the standard solids, the mesh integrals for hulls, parallel axes and sums
// for several (chapter 2).
// Not handled: shapes that overlap count twice; half-spaces have no weight.

#include <span>

#include "carom/mass/mass_properties.hpp"
#include "carom/world/body.hpp"

namespace carom::world {

/// The mass properties of shapes that are joined.
/// \param shapes usable, with positive densities; at least one, none a half-space or ground
/// \return mass, centre and inertia in the frame in which the shapes stand
/// \throws InvalidInput if there is nothing to weigh
/// \ingroup world
MassProperties weighShapes(std::span<const ShapeDescription> shapes);

}  // namespace carom::world
