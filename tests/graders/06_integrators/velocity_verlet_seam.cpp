#include "carom/motion/velocity_verlet.hpp"

#include "grading/fields_motion.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(State, velocityVerlet,
           (const State& state, Real time, Real dt, const Acceleration& acceleration),
           (state, time, dt, acceleration))
