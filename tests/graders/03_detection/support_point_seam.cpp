#include "carom/detection/support_point.hpp"

#include "grading/fields_detection.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::size_t, supportPoint, (std::span<const Vector3> points, const Vector3& direction),
           (points, direction))
