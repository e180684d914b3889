#include "carom/precision/time_of_step.hpp"

#include "grading/seam.hpp"

CAROM_SEAM(Real, timeOfStep, (std::int64_t step, Real dt, Real start), (step, dt, start))
