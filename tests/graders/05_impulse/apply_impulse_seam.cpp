#include "carom/impulse/apply_impulse.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(void, applyImpulse,
           (OrientedBody & a, const Vector3& armA, OrientedBody& b, const Vector3& armB,
            const Vector3& impulse),
           (a, armA, b, armB, impulse))
