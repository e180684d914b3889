// Every particle looks at all others, with the formula written out; each bond is met twice.
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/motion/pair_forces.hpp"

namespace carom {

CrowdForces pairForces(std::span<const Vector3> positions, const LennardJones& atoms,
                       const Vector3& box) {
  const auto [e, s, cut] = atoms;
  if (!(e > 0 && s > 0 && cut > 0) || !box.allFinite()) throw InvalidInput("no such atoms");
  for (int k = 0; k < 3; ++k) {
    if (box[k] != 0 && !(box[k] >= 2 * cut * s)) throw InvalidInput("the box is too small");
  }
  const Real lift = 4 * e * (std::pow(cut, -12) - std::pow(cut, -6));
  CrowdForces crowd;
  for (const Vector3& here : positions) {
    if (!here.allFinite()) throw InvalidInput("no such place");
    Vector3 force(0, 0, 0);
    for (const Vector3& there : positions) {
      if (&there == &here) continue;
      Vector3 away = here - there;
      for (int k = 0; k < 3; ++k) {
        if (box[k] == 0) continue;
        while (away[k] > box[k] / 2) away[k] -= box[k];
        while (away[k] < -box[k] / 2) away[k] += box[k];
      }
      const Real r = std::sqrt(away.squaredNorm());
      if (r == 0) throw InvalidInput("two particles in one place");
      if (r >= cut * s) continue;
      const Real sixth = std::pow(s / r, 6);
      force += 24 * e * (2 * sixth * sixth - sixth) / r * (away / r);
      crowd.energy += (4 * e * (sixth * sixth - sixth) - lift) / 2;
    }
    crowd.forces.push_back(force);
  }
  return crowd;
}

}  // namespace carom
