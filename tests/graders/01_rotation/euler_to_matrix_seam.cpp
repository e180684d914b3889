#include "carom/rotation/euler_to_matrix.hpp"

#include "grading/fields_rotation.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Matrix3, eulerToMatrix, (const EulerAngles& angles), (angles))
