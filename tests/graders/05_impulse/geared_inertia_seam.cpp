#include "geared_inertia.hpp"

#include "geared_inertia_fields.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, gearedInertia, (std::span<const GearWheel> train), (train))
