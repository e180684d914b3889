#pragma once
// In what are the particles, and what happens at its edges?
//
// Method: a box from the origin to its size. Along each axis either opposite sides are one (who
// leaves comes in on the other side: a small piece of something endless), or there are walls, or
// there is nothing: all particles lie in one plane, and the world is two-dimensional.
// A wall is a mirror, in which a particle sees itself. It is pushed away by its own image as it
// would be by another particle: only pushed, as the force is cut off where it would begin to pull,
// and with half of the pair's energy, as the other half is the image's.
// Why not turn the velocity round at the wall: the force would jump there, from that of a particle
// coming to that of its image going, and velocity Verlet would gain or lose an energy of order dt
// at each bounce. The image's force begins at zero and grows smoothly: all errors stay of order
// dt^2.
// Source: Allen and Tildesley, Computer Simulation of Liquids, 1987, section 1.5.
// Not handled: boxes that are not rectangular, walls that move or warm.

#include <array>

#include "carom/motion/lennard_jones.hpp"

namespace carom {

/// What stands at both ends of one axis of a box. \ingroup motion
enum class Edge {
  Periodic,  ///< who leaves comes in on the other side
  Wall,      ///< a mirror: who comes near is pushed back by its own image
  Flat,      ///< no room at all: every particle has zero here, position and velocity
};

/// A rectangular box with a corner at the origin. \ingroup motion
struct ParticleBox {
  Vector3 size = Vector3::Zero();  ///< lengths of the edges; not looked at where flat [m, world]
  std::array<Edge, 3> edges = {Edge::Periodic, Edge::Periodic, Edge::Periodic};  ///< along x, y, z
};

/// How many dimensions the box has. \param box any box \return 0 to 3: those that are not flat
/// \ingroup motion
int dimensionsOf(const ParticleBox& box);

/// What a wall does to a particle: the force of its image in the mirror.
/// \param atoms their depth and size
/// \param distance of the particle from the wall, positive [m]
/// \return force away from the wall divided by the distance to the image, which is twice that to
/// the wall; and the half of the pair's energy that is the particle's
/// \ingroup motion
PairForce wallForce(const LennardJones& atoms, Real distance);

/// Area or volume.
/// \param box any box
/// \return product of the edges that are not flat [m^d]
/// \ingroup motion
Real volumeOf(const ParticleBox& box);

/// Refuses a box that particles of this reach cannot be in.
/// \param box any box
/// \param atoms for their cut-off distance
/// \throws InvalidInput if all axes are flat, a size is not finite, a periodic edge is shorter than
/// two cut-offs (a particle would see two images of another), or one between walls shorter than one
/// \ingroup motion
void requireUsable(const ParticleBox& box, const LennardJones& atoms);

/// Refuses a particle that is not in the box. Along a periodic axis every place is in it.
/// \param box any box
/// \param atoms for their size
/// \param position [m, world]
/// \param velocity [m/s, world]
/// \throws InvalidInput if a number is not finite, the position is behind a wall or nearer to it than
/// a quarter of the size (half the size from its image), or either has a component along a flat axis
/// \ingroup motion
void requireInside(const ParticleBox& box, const LennardJones& atoms, const Vector3& position,
                   const Vector3& velocity);

}  // namespace carom
