#include "angle_between.hpp"

#include "grading/fields_rotation.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, angleBetween, (const Quaternion& a, const Quaternion& b), (a, b))
