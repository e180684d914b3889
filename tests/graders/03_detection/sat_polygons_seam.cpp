#include "carom/detection/sat_polygons.hpp"

#include "grading/fields_detection.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(SeparatingAxis, satPolygons, (std::span<const Vector2> a, std::span<const Vector2> b),
           (a, b))
