#include "carom/mass/parallel_axis.hpp"

#include "grading/fields_mass.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Matrix3, parallelAxis,
           (const Matrix3& inertiaAboutCenter, Real mass, const Vector3& offset),
           (inertiaAboutCenter, mass, offset))
