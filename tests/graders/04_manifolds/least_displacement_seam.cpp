#include "carom/manifold/least_displacement.hpp"

#include "grading/fields_manifold.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(LeastDisplacement, leastDisplacement,
           (std::span<const Vector3> axes, std::span<const Vector3> a, std::span<const Vector3> b),
           (axes, a, b))
