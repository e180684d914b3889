#include "carom/mass/principal_axes.hpp"

#include "grading/fields_mass.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(PrincipalAxes, principalAxes, (const Matrix3& inertia), (inertia))
