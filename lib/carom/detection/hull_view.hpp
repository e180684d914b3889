#pragma once
// A polyhedron as the fast tests see it: pointers to the arrays of a hull, or of a box.
//
// Boxes meet hulls so often that making a hull of the box each time would cost more than the test.
// Its topology is always the same and is a constant here; its corners and planes fit on the stack.
// Numbering as in boxHull(): faces -x, +x, -y, +y, -z, +z; vertex i is positive along axis k where
// bit k of i is set.
// Not handled: nothing is owned; a view dies with its hull.

#include <array>
#include <cstdint>

#include "carom/core/real.hpp"
#include "carom/detection/convex_hull.hpp"
#include "carom/detection/shapes.hpp"

namespace carom::detail {

/// Pointers to the parts of a polyhedron, see ConvexHull. \ingroup detection
struct HullView {
  const Vector3* vertices = nullptr;          ///< corners [m, body]
  const Real* x = nullptr;                    ///< first coordinates of the corners [m]
  const Real* y = nullptr;                    ///< second coordinates [m]
  const Real* z = nullptr;                    ///< third coordinates [m]
  const HullFace* faces = nullptr;            ///< planes and loops
  const HullHalfEdge* halfEdges = nullptr;    ///< face by face
  const HullEdge* edges = nullptr;            ///< each edge once
  const std::int32_t* anyHalfEdge = nullptr;  ///< per vertex one half-edge that starts there
  int vertexCount = 0;                        ///< number of corners
  int faceCount = 0;                          ///< number of faces
  int edgeCount = 0;                          ///< number of edges
  Vector3 centroid = Vector3::Zero();         ///< a point inside [m, body]
  Real boundingRadius = 0;                    ///< about the centroid [m]
};

/// A view of a hull. \param hull must outlive the view \return the view \ingroup detection
inline HullView viewOf(const ConvexHull& hull) {
  return {hull.vertices.data(),
          hull.x.data(),
          hull.y.data(),
          hull.z.data(),
          hull.faces.data(),
          hull.halfEdges.data(),
          hull.edges.data(),
          hull.anyHalfEdge.data(),
          static_cast<int>(hull.vertices.size()),
          static_cast<int>(hull.faces.size()),
          static_cast<int>(hull.edges.size()),
          hull.centroid,
          hull.boundingRadius};
}

/// The corners and planes of a box, laid out as those of a hull. \ingroup detection
class BoxHullView {
 public:
  /// Lays out a box. \param box its half extents
  explicit BoxHullView(const Box& box);
  BoxHullView(const BoxHullView&) = delete;
  BoxHullView& operator=(const BoxHullView&) = delete;

  /// The view of it. \return pointers into this object \ingroup detection
  HullView view() const;

 private:
  std::array<Vector3, 8> vertices_;
  std::array<Real, 8> x_, y_, z_;
  std::array<HullFace, 6> faces_;
  Real radius_ = 0;
};

}  // namespace carom::detail
