#pragma once
// A convex solid with flat faces: how is it stored?
//
// Method: vertices; faces as loops of half-edges, counter-clockwise seen from outside, with outward
// unit normals; edges with the two faces that they separate. The half-edges of one face stand in
// one row, in order, so that clipping walks over an array. The two normals at an edge span its arc
// on the Gauss map, which tells at once which pairs of edges can be the closest ones (Gregorius,
// GDC 2013). The coordinates are kept a second time in columns, for the search of the farthest
// vertex.
// Why a struct that nobody writes by hand: hullOfPoints() and hullFromFaces() make hulls that keep
// the promises below.
// Not handled: flat and open surfaces; they are refused.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// One flat face of a hull. \ingroup detection
struct HullFace {
  Vector3 normal = Vector3::Zero();  ///< unit, outward [1, body]
  Real offset = 0;                   ///< all points of the solid have normal . x <= offset [m]
  std::int32_t firstHalfEdge = 0;    ///< its half-edges are this one and the next count - 1
  std::int32_t count = 0;            ///< number of its corners, at least 3
};

/// One side of an edge: it runs along its face, counter-clockwise seen from outside.
/// \ingroup detection
struct HullHalfEdge {
  std::int32_t origin = 0;  ///< vertex where it starts
  std::int32_t next = 0;    ///< half-edge that follows on the same face
  std::int32_t twin = 0;    ///< the other side, running the other way
  std::int32_t face = 0;    ///< the face it bounds
  std::int32_t edge = 0;    ///< the edge it is a side of
};

/// An edge, once. \ingroup detection
struct HullEdge {
  std::int32_t from = 0;       ///< first vertex
  std::int32_t to = 0;         ///< second vertex
  std::int32_t leftFace = 0;   ///< the face along which it runs from `from` to `to`
  std::int32_t rightFace = 0;  ///< the face on the other side
};

/// A convex polyhedron in its own frame. \ingroup detection
struct ConvexHull {
  std::vector<Vector3> vertices;          ///< corners [m, body]
  std::vector<Real> x;                    ///< first coordinates of the corners [m, body]
  std::vector<Real> y;                    ///< second coordinates [m, body]
  std::vector<Real> z;                    ///< third coordinates [m, body]
  std::vector<HullFace> faces;            ///< faces, no two in one plane
  std::vector<HullHalfEdge> halfEdges;    ///< sides of the edges, face by face
  std::vector<HullEdge> edges;            ///< each edge once
  std::vector<std::int32_t> anyHalfEdge;  ///< per vertex: one half-edge that starts there
  Vector3 centroid = Vector3::Zero();     ///< centre of volume, inside the solid [m, body]
  Real volume = 0;                        ///< positive [m^3]
  Real boundingRadius = 0;                ///< no point is farther from the centroid [m]
};

/// How far a corner may stand off the plane of its face, relative to the largest coordinate of the
/// hull: 64 ulp. Rotating a cube rounds each coordinate of its corners by half an ulp, and a plane
/// through three of them misses the fourth by a few; what is flatter than this counts as flat.
/// \ingroup detection
inline constexpr Real kFlatness = 64 * 2.220446049250313e-16;

/// A hull from faces that are known, for example those of a mesh file.
/// \param vertices corners [m, body]; each is used by a face
/// \param faces loops of indices into vertices, counter-clockwise seen from outside, each flat
/// \param flatness how far a corner may stand off a face, relative to the largest coordinate [1]
/// \return the hull, with the vertices and faces in the order given
/// \throws InvalidInput if a coordinate is not finite, an index names no vertex, the faces do not
///   close, a face is not flat or has no area, or a vertex lies outside a face (the message says
///   which: the solid is not convex)
/// \ingroup detection
ConvexHull hullFromFaces(std::span<const Vector3> vertices,
                         std::span<const std::vector<std::int32_t>> faces,
                         Real flatness = kFlatness);

/// A box as a hull, so that one function serves boxes and hulls.
/// \param halfExtents half lengths along x, y, z, all positive [m, body]
/// \return hull of 8 vertices, 6 faces (-x, +x, -y, +y, -z, +z) and 12 edges; vertex i has the sign
///   + along axis k where bit k of i is set
/// \throws InvalidInput if a half extent is not positive and finite
/// \ingroup detection
ConvexHull boxHull(const Vector3& halfExtents);

}  // namespace carom
