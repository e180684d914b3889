#include "carom/mass/combine_bodies.hpp"

#include "grading/fields_mass.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(MassProperties, combineBodies, (std::span<const MassProperties> parts), (parts))
