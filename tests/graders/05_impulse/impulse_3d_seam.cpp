#include "carom/impulse/impulse_3d.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, impulse3d,
           (const MovingBody& a, const MovingBody& b, const Contact& contact, Real restitution),
           (a, b, contact, restitution))
