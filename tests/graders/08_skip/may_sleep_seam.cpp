#include "carom/world/may_sleep.hpp"

#include "grading/fields_world.hpp"
#include "grading/seam.hpp"

using namespace carom::world;

CAROM_SEAM(bool, maySleep, (const RestWatch& watch, const RestLimits& limits), (watch, limits))
