#include "carom/motion/verlet.hpp"

#include "grading/fields_motion.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(TwoPositions, verlet,
           (const TwoPositions& positions, Real time, Real dt, const Acceleration& acceleration),
           (positions, time, dt, acceleration))
