#include "carom/detection/project.hpp"

#include "grading/fields_detection.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Interval, project, (std::span<const Vector3> points, const Vector3& axis),
           (points, axis))
