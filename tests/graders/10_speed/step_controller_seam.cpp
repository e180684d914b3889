#include "carom/motion/step_controller.hpp"

#include "grading/fields_motion.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(StepChoice, stepController, (const StepTry& done), (done))
