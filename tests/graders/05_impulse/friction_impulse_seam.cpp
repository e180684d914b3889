#include "carom/impulse/friction_impulse.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Vector3, frictionImpulse,
           (const Vector3& relativeVelocity, const Vector3& normal, Real normalImpulse,
            Real friction, Real tangentialMass),
           (relativeVelocity, normal, normalImpulse, friction, tangentialMass))
