#include "carom/rotation/axis_angle_to_quaternion.hpp"

#include "grading/fields_rotation.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Quaternion, axisAngleToQuaternion, (const Vector3& axis, Real angle), (axis, angle))
