#include "carom/rotation/axis_angle_to_matrix.hpp"

#include "grading/fields_rotation.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Matrix3, axisAngleToMatrix, (const Vector3& axis, Real angle), (axis, angle))
