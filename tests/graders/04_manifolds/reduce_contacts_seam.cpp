#include "carom/manifold/reduce_contacts.hpp"

#include "grading/fields_manifold.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<int>, reduceContacts,
           (std::span<const Vector3> corners, std::span<const Real> separations),
           (corners, separations))
