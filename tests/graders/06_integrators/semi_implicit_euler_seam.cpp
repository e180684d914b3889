#include "carom/motion/semi_implicit_euler.hpp"

#include "grading/fields_motion.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(State, semiImplicitEuler,
           (const State& state, Real time, Real dt, const Acceleration& acceleration),
           (state, time, dt, acceleration))
