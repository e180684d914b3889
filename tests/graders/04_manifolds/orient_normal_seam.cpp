#include "carom/manifold/orient_normal.hpp"

#include "grading/fields_manifold.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Vector3, orientNormal,
           (const Vector3& axis, std::span<const Vector3> a, std::span<const Vector3> b),
           (axis, a, b))
