#pragma once
// How does a crowd of particles begin?
//
// Method: on the sites of a square or cubic lattice, where nobody is too near to anybody; with
// random velocities, from which the mean is taken so that the crowd as a whole stays where it is,
// brought to the temperature that was asked for. Each component of a velocity is drawn evenly
// between two bounds; collisions make the bell curve of Maxwell of it within a time of one or two.
// Why not draw from the bell curve: it needs logarithms and cosines, which are not the same bits on
// every machine.
// Source: Allen and Tildesley, Computer Simulation of Liquids, 1987, section 5.7.
// Not handled: keeping the temperature. The lattice melts, and what its energy changes by, the
// temperature does too.

#include <array>
#include <cstdint>
#include <vector>

#include "carom/motion/particle_box.hpp"

namespace carom {

/// What a crowd begins with. \ingroup motion
struct LatticePlan {
  std::array<int, 3> sites = {10, 10, 10};  ///< particles along x, y, z, positive; 1 where flat
  Real density = 0.5;                       ///< particles per area or volume, positive [1/m^d]
  Real temperature = 1;                     ///< m v^2 per dimension, not negative [J]
  Real mass = 1;                            ///< of each, positive [kg]
  std::array<Edge, 3> edges = {Edge::Periodic, Edge::Periodic, Edge::Periodic};  ///< of the box
  std::uint64_t seed = 1;                                                        ///< any number
};

/// A crowd that begins. \ingroup motion
struct LatticeStart {
  ParticleBox box;                  ///< as large as the density asks for
  std::vector<Vector3> positions;   ///< in the middle of equal squares or cubes [m, world]
  std::vector<Vector3> velocities;  ///< their sum is zero to rounding [m/s, world]
};

/// Puts particles on a lattice.
/// \param plan how many, how dense, how warm
/// \return box, positions and velocities, for Particles
/// \throws InvalidInput if a number of sites is not positive, or not 1 where flat, there are more
/// than a hundred million, only one is to be warm, density or mass is not positive, the temperature
/// negative or not finite, or all axes are flat
/// \ingroup motion
LatticeStart latticeStart(const LatticePlan& plan);

}  // namespace carom
