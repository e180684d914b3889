#include "stopping_errors.hpp"

#include "grading/seam.hpp"
#include "stopping_errors_fields.hpp"

CAROM_SEAM(std::vector<StoppingError>, stoppingErrors,
           (Real speed, Real friction, std::span<const Real> steps), (speed, friction, steps))
