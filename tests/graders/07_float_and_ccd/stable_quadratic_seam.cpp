#include "carom/precision/stable_quadratic.hpp"

#include "grading/fields_precision.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(QuadraticRoots, stableQuadratic, (Real a, Real b, Real c), (a, b, c))
