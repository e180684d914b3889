#include "carom/impulse/spinning_friction.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, spinningFriction, (const SpinningContact& contact), (contact))
