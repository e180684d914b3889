#include "carom/motion/rk4.hpp"

#include "grading/fields_motion.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(State, rk4, (const State& state, Real time, Real dt, const Acceleration& acceleration),
           (state, time, dt, acceleration))
