#include "carom/impulse/effective_mass.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, effectiveMass, (const BodyMass& a, const BodyMass& b, const Contact& contact),
           (a, b, contact))
