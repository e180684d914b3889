#include "tangent_rows.hpp"

#include "grading/seam.hpp"
#include "tangent_rows_fields.hpp"

CAROM_SEAM(std::vector<TangentRow>, tangentRows, (Real end, int steps), (end, steps))
