#include "sticking_impulse.hpp"

#include "grading/seam.hpp"

CAROM_SEAM(Vector2, stickingImpulse, (const Matrix2& K, const Vector2& velocity, Real restitution),
           (K, velocity, restitution))
