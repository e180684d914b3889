#include "carom/motion/pair_forces.hpp"

#include "grading/fields_motion.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(CrowdForces, pairForces,
           (std::span<const Vector3> positions, const LennardJones& atoms, const Vector3& box),
           (positions, atoms, box))
