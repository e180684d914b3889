#include "carom/world/may_sleep.hpp"

#include "grading/fields_world.hpp"
#include "grading/seam.hpp"

CAROM_SEAM_IN(carom::world, bool, maySleep,
              (const world::RestWatch& watch, const world::RestLimits& limits), (watch, limits))
