#include "carom/motion/explicit_euler.hpp"

#include "grading/fields_motion.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(State, explicitEuler,
           (const State& state, Real time, Real dt, const Acceleration& acceleration),
           (state, time, dt, acceleration))
