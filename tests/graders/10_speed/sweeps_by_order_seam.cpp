#include "sweeps_by_order.hpp"

#include "grading/seam.hpp"
#include "speed_fields.hpp"

CAROM_SEAM(std::vector<SweepsByOrder>, sweepsByOrder, (std::span<const int> heights), (heights))
