#include "lanes_solver.hpp"

#include "grading/seam.hpp"
#include "speed_fields.hpp"

CAROM_SEAM(void, lanesSolver, (std::span<RowBlock> blocks, std::span<BodySpeeds> speeds),
           (blocks, speeds))
