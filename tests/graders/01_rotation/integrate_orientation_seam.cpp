#include "carom/rotation/integrate_orientation.hpp"

#include "grading/fields_rotation.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Quaternion, integrateOrientation,
           (const Quaternion& q, const Vector3& angularVelocity, Real dt), (q, angularVelocity, dt))
