#include "carom/solver/friction_pyramid_to_cone.hpp"

#include "grading/seam.hpp"

CAROM_SEAM(Vector2, frictionPyramidToCone,
           (const Vector2& friction, const Vector2& slip, Real mass, Real limit),
           (friction, slip, mass, limit))
