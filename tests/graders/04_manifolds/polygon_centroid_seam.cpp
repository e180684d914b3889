#include "carom/manifold/polygon_centroid.hpp"

#include "grading/fields_manifold.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(PolygonArea, polygonCentroid, (std::span<const Vector3> polygon), (polygon))
