#include "carom/rotation/rotate_point.hpp"

#include "grading/fields_rotation.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Vector3, rotatePoint, (const Quaternion& q, const Vector3& v), (q, v))
