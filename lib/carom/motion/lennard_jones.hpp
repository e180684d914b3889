#pragma once
// How do two atoms without charge push and pull each other?
//
// Method: the potential of Lennard and Jones, 4 e ((s/r)^12 - (s/r)^6), cut off at a distance
// beyond which it hardly matters, and lifted so that it is zero there. Without the lift a pair that
// crosses the cut-off gains or loses a little energy each time, and no integrator could keep the
// total.
// Source: Lennard-Jones 1924; Allen and Tildesley, Computer Simulation of Liquids, 1987, section
// 1.3.
// Not handled: the force itself still jumps at the cut-off, by 0.039 e/s at 2.5 s.

#include "carom/core/real.hpp"

namespace carom {

/// Two atoms: how strongly they attract, how large they are, how far they feel each other.
/// \ingroup motion
struct LennardJones {
  Real depth = 1;     ///< e, energy of the bond, positive [J]
  Real size = 1;      ///< s, the distance of no potential, positive [m]
  Real cutoff = 2.5;  ///< in units of the size; beyond it there is nothing, positive [1]
};

/// What a distance does. \ingroup motion
struct PairForce {
  Real factor = 0;  ///< force divided by distance, positive if they push each other away [N/m]
  Real energy = 0;  ///< of the pair [J]
};

/// Force and energy of two atoms.
/// \param atoms their depth, size and cut-off
/// \param distanceSquared square of the distance, positive [m^2]
/// \return force divided by distance, and energy; zeros from the cut-off on
/// \ingroup motion
inline PairForce pairForce(const LennardJones& atoms, Real distanceSquared) {
  const Real limit = atoms.cutoff * atoms.size;
  if (distanceSquared >= limit * limit) return {};
  const auto sixth = [](Real x) { return x * x * x; };
  const Real s6 = sixth(atoms.size * atoms.size / distanceSquared);
  const Real cut6 = sixth(1 / (atoms.cutoff * atoms.cutoff));
  return {24 * atoms.depth * (2 * s6 * s6 - s6) / distanceSquared,
          4 * atoms.depth * (s6 * s6 - s6 - (cut6 * cut6 - cut6))};
}

}  // namespace carom
