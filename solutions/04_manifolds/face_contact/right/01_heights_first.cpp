// Side planes through unit normals, and the heights from the plane's own offset.
#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/manifold/clip_polygon.hpp"
#include "carom/manifold/face_contact.hpp"

namespace carom {

std::vector<FacePoint> faceContact(std::span<const Vector3> reference, const Vector3& normal,
                                   std::span<const Vector3> incident, Real margin) {
  const std::size_t n = reference.size();
  if (n < 3) throw InvalidInput("a face has three corners or more");
  std::vector<Vector3> left(incident.begin(), incident.end());
  for (std::size_t i = n; i-- > 0;) {
    const Vector3& start = reference[i];
    const Vector3& end = i + 1 == n ? reference[0] : reference[i + 1];
    const Vector3 inward = cross(normal, Vector3(end - start).normalized());
    left = clipPolygon(left, -inward, -inward.dot(end));
  }
  const Real offset = normal.dot(reference[n - 1]);
  std::vector<FacePoint> contact;
  for (const Vector3& p : left) {
    FacePoint point;
    point.position = p;
    point.separation = p.dot(normal) - offset;
    if (!(point.separation > margin)) contact.push_back(point);
  }
  return contact;
}

}  // namespace carom
