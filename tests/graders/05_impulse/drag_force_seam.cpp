#include "carom/impulse/drag_force.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Vector3, dragForce, (const Vector3& velocity, const AirDrag& air), (velocity, air))
