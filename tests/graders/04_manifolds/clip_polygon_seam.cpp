#include "carom/manifold/clip_polygon.hpp"

#include "grading/fields_manifold.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<Vector3>, clipPolygon,
           (std::span<const Vector3> polygon, const Vector3& normal, Real offset),
           (polygon, normal, offset))
