#include "advance_cost.hpp"

#include "advance_cost_fields.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<AdvanceCost>, advanceCost, (Real caution, std::span<const Real> tolerances),
           (caution, tolerances))
