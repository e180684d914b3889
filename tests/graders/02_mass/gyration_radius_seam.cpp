#include "gyration_radius.hpp"

#include "grading/fields_mass.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, gyrationRadius, (const MassProperties& body, const Vector3& axis), (body, axis))
