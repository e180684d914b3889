#include "carom/impulse/angular_acceleration.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Vector3, angularAcceleration,
           (const Matrix3& inertia, const Vector3& angularVelocity, const Vector3& torque),
           (inertia, angularVelocity, torque))
