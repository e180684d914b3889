#include "carom/rotation/matrix_to_euler.hpp"

#include "grading/fields_rotation.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(EulerAngles, matrixToEuler, (const Matrix3& R), (R))
