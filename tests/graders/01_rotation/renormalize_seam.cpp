#include "carom/rotation/renormalize.hpp"

#include "grading/fields_rotation.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Quaternion, renormalize, (const Quaternion& q), (q))
