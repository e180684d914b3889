// Exercise 04.face_contact: where do two faces touch?
// Check it with: ./course check 04.face_contact

#include "carom/manifold/face_contact.hpp"

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"
#include "carom/manifold/clip_polygon.hpp"

namespace carom {

std::vector<FacePoint> faceContact(std::span<const Vector3> reference, const Vector3& normal,
                                   std::span<const Vector3> incident, Real margin) {
  // Given: what is no face is refused.
  if (reference.size() < 3) throw InvalidInput("faceContact: a reference face needs 3 corners");
  // clipPolygon(polygon, normal, offset) keeps what lies behind a plane. A plane through a corner c
  // has the offset normal.dot(c).
  return todo<std::vector<FacePoint>>("faceContact");
}

}  // namespace carom
