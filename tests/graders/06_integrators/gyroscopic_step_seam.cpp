#include "carom/motion/gyroscopic_step.hpp"

#include "grading/fields_motion.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Vector3, gyroscopicStep,
           (const Matrix3& inertia, const Vector3& angularVelocity, Real dt),
           (inertia, angularVelocity, dt))
