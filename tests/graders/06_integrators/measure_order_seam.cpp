#include "carom/motion/measure_order.hpp"

#include "grading/fields_motion.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, measureOrder, (const StepError& coarse, const StepError& fine), (coarse, fine))
