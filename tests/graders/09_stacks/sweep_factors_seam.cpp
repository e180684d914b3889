#include "sweep_factors.hpp"

#include "grading/seam.hpp"
#include "sweep_factors_fields.hpp"

CAROM_SEAM(std::vector<SweepFactor>, sweepFactors, (std::span<const int> counts), (counts))
