#include "carom/impulse/impulse_2d.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, impulse2d,
           (const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact,
            Real restitution),
           (a, b, contact, restitution))
