#include "carom/rotation/quaternion_exponential.hpp"

#include "grading/fields_rotation.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Quaternion, quaternionExponential, (const Vector3& rotationVector), (rotationVector))
