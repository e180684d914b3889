#include "carom/detection/aabb_of_points.hpp"

#include "grading/fields_detection.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Aabb<3>, aabbOfPoints, (std::span<const Vector3> points), (points))
