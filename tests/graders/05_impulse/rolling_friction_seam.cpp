#include "carom/impulse/rolling_friction.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Vector3, rollingFriction, (const RollingContact& contact), (contact))
