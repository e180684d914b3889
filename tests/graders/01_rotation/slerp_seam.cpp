#include "carom/rotation/slerp.hpp"

#include "grading/fields_rotation.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Quaternion, slerp, (const Quaternion& a, const Quaternion& b, Real t), (a, b, t))
