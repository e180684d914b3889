#include "carom/toi/conservative_advancement.hpp"

#include "grading/fields_toi.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(TimeOfImpact, conservativeAdvancement,
           (const std::function<Real(Real time)>& gap, Real fastest, Real duration, Real tolerance,
            int maxSteps),
           (gap, fastest, duration, tolerance, maxSteps))
