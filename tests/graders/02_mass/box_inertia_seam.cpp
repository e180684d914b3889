#include "carom/mass/box_inertia.hpp"

#include "grading/fields_mass.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Matrix3, boxInertia, (Real mass, const Vector3& size), (mass, size))
