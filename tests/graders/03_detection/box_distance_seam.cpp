#include "box_distance.hpp"

#include "grading/fields_detection.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, boxDistance, (const Aabb<3>& a, const Aabb<3>& b), (a, b))
