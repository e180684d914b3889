// Exercise 06.pair_forces: what pushes each particle of a crowd?
// Check it with: ./course check 06.pair_forces

#include "carom/motion/pair_forces.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

CrowdForces pairForces(std::span<const Vector3> positions, const LennardJones& atoms,
                       const Vector3& box) {
  // Given: what cannot be worked with is refused.
  for (const Vector3& position : positions) requireFinite(position, "position");
  requirePositive(atoms.depth, "depth");
  requirePositive(atoms.size, "size");
  requirePositive(atoms.cutoff, "cutoff");
  requireFinite(box, "box");
  for (int axis = 0; axis < 3; ++axis) {
    if (box[axis] != 0 && !(box[axis] >= 2 * atoms.cutoff * atoms.size)) {
      reject("box", toText(box), "must be zero or at least twice the cut-off along each axis");
    }
  }
  CrowdForces crowd;
  crowd.forces.assign(positions.size(), Vector3::Zero());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (std::size_t j = i + 1; j < positions.size(); ++j) {
      Vector3 d = positions[j] - positions[i];
      for (int axis = 0; axis < 3; ++axis) {
        if (box[axis] != 0) d[axis] -= box[axis] * std::round(d[axis] / box[axis]);
      }
      if (d.squaredNorm() == 0) reject("position", toText(positions[j]), "must be taken only once");
      const PairForce pair = pairForce(atoms, d.squaredNorm());
      crowd.forces[i] -= pair.factor * d / std::sqrt(d.squaredNorm());
      crowd.forces[j] += pair.factor * d / std::sqrt(d.squaredNorm());
      crowd.energy += pair.energy;
    }
  }
  return crowd;
}

}  // namespace carom
