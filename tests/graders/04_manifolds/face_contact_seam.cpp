#include "carom/manifold/face_contact.hpp"

#include "grading/fields_manifold.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<FacePoint>, faceContact,
           (std::span<const Vector3> reference, const Vector3& normal,
            std::span<const Vector3> incident, Real margin),
           (reference, normal, incident, margin))
