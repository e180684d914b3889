#include "carom/detection/gjk_distance.hpp"

#include "grading/fields_detection.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(PointDistance, gjkDistance, (std::span<const Vector3> a, std::span<const Vector3> b),
           (a, b))
