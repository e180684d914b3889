#include "carom/manifold/edge_contact.hpp"

#include "grading/fields_manifold.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(EdgeContact, edgeContact,
           (const Vector3& a0, const Vector3& a1, const Vector3& b0, const Vector3& b1,
            const Vector3& axis),
           (a0, a1, b0, b1, axis))
