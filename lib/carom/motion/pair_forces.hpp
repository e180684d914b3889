#pragma once
// What pushes each particle of a crowd?
//
// Method: for every pair, the force of one on the other, added to one and taken from the other. So
// the sum of all forces is zero, to rounding, and total momentum stays. In a periodic box the
// particle that counts is the nearest of all images of the other: the difference of the positions,
// less the nearest whole number of boxes.
// Why every pair once: half the work, and Newton's third law holds by the way it is written.
// Source: Allen and Tildesley, Computer Simulation of Liquids, 1987, sections 1.5 and 5.1.
// Not handled: many particles. The pairs grow like n^2, and of ten thousand particles nearly all
// pairs are beyond the cut-off.

#include <span>
#include <vector>

#include "carom/motion/lennard_jones.hpp"

namespace carom {

/// The forces on all particles. \ingroup motion
struct CrowdForces {
  std::vector<Vector3> forces;  ///< n of them [N, world]
  Real energy = 0;              ///< of all pairs [J]
};

/// The forces of all pairs of particles on each other.
/// \param positions n points [m, world]
/// \param atoms depth, size and cut-off of the force
/// \param box edges of the periodic box; zero along an axis where there is none. An edge must be at
/// least twice the cut-off distance, so that no particle sees two images of another [m]
/// \return a force for each particle, and the energy of all pairs
/// \throws InvalidInput if a number is not finite, a property of the atoms not positive, the box
/// too small, or two particles are in one place
/// \ingroup motion
CrowdForces pairForces(std::span<const Vector3> positions, const LennardJones& atoms,
                       const Vector3& box = Vector3::Zero());

}  // namespace carom
