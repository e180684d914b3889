#include "merge_found.hpp"

#include "grading/seam.hpp"
#include "speed_fields.hpp"

CAROM_SEAM(std::vector<FoundImpact>, mergeFound, (std::span<const std::vector<FoundImpact>> lists),
           (lists))
