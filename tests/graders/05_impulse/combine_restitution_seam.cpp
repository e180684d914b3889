#include "carom/impulse/combine_restitution.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, combineRestitution, (Real a, Real b, RestitutionRule rule), (a, b, rule))
