#include "carom/impulse/impulse_wall.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, impulseWall,
           (const MovingBody& body, const Vector3& arm, const Vector3& normal, Real restitution),
           (body, arm, normal, restitution))
