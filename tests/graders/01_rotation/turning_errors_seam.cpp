#include "turning_errors.hpp"

#include "grading/seam.hpp"
#include "turning_errors_fields.hpp"

CAROM_SEAM(std::vector<TurningError>, turningErrors,
           (const TurningStep& step, const Quaternion& start, const Quaternion& end, Real duration,
            std::span<const int> counts),
           (step, start, end, duration, counts))
