#include "carom/impulse/point_velocity.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Vector3, pointVelocity, (const Velocity& body, const Vector3& arm), (body, arm))
