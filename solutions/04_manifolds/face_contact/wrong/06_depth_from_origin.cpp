// Exercise 04.face_contact: where do two faces touch?
// Check it with: ./course check 04.face_contact

#include "carom/manifold/face_contact.hpp"

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/manifold/clip_polygon.hpp"

namespace carom {

std::vector<FacePoint> faceContact(std::span<const Vector3> reference, const Vector3& normal,
                                   std::span<const Vector3> incident, Real margin) {
  if (reference.size() < 3) throw InvalidInput("faceContact: a reference face needs 3 corners");

  // Cut by the plane on each edge; edge x normal points out of the face.
  std::vector<Vector3> common(incident.begin(), incident.end());
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const Vector3& corner = reference[i];
    const Vector3 edge = reference[(i + 1) % reference.size()] - corner;
    const Vector3 outward = cross(edge, normal);
    common = clipPolygon(common, outward, outward.dot(corner));
  }

  // What is left above or below the reference face; only what is below counts.
  std::vector<FacePoint> points;
  for (const Vector3& position : common) {
    const Real separation = normal.dot(position);
    if (separation <= margin) points.push_back({position, separation});
  }
  return points;
}

}  // namespace carom
