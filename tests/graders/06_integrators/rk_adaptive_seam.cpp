#include "carom/motion/rk_adaptive.hpp"

#include "grading/fields_motion.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(AdaptiveRun, rkAdaptive,
           (const State& state, Real time, Real end, const Tolerance& tolerance,
            const Acceleration& acceleration),
           (state, time, end, tolerance, acceleration))
