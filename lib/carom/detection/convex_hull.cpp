#include "carom/detection/convex_hull.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/limits.hpp"

namespace carom {
namespace {

using Index = std::int32_t;

std::size_t at(Index index) {
  return static_cast<std::size_t>(index);
}

std::string vertexText(Index index, const Vector3& vertex) {
  return std::to_string(index) + " at " + toText(vertex);
}

// Twice the area times the normal: the sum of the fan's triangles, exact in direction also when
// the first three corners are nearly in a line (Newell's method, measured from the first corner).
Vector3 areaVector(const ConvexHull& hull, const std::vector<Index>& loop) {
  const Vector3& origin = hull.vertices[at(loop[0])];
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum += cross(hull.vertices[at(loop[i])] - origin, hull.vertices[at(loop[i + 1])] - origin);
  }
  return sum;
}

void addFace(ConvexHull& hull, const std::vector<Index>& loop) {
  const Index face = static_cast<Index>(hull.faces.size());
  const Index count = static_cast<Index>(loop.size());
  const Index first = static_cast<Index>(hull.halfEdges.size());
  if (count < 3) {
    reject("face " + std::to_string(face), std::to_string(count) + " corners",
           "must have at least 3");
  }
  for (Index i = 0; i < count; ++i) {
    const Index v = loop[at(i)];
    if (v < 0 || v >= static_cast<Index>(hull.vertices.size())) {
      reject("face " + std::to_string(face), "corner " + std::to_string(v), "must name a vertex");
    }
    hull.halfEdges.push_back({v, first + (i + 1) % count, -1, face, -1});
    hull.anyHalfEdge[at(v)] = first + i;
  }
  const Vector3 direction = scaledToOne(areaVector(hull, loop));
  if (direction.isZero(0)) {
    reject("face " + std::to_string(face), "area 0", "must have corners that are not in a line");
  }
  // The rounding of the cross products of a needle tilts the normal along the needle, where a small
  // angle is a large height. Its longest edge lies in the plane, so that part can be taken out.
  Vector3 longest = Vector3::Zero();
  for (Index i = 0; i < count; ++i) {
    const Vector3 edge =
        hull.vertices[at(loop[at((i + 1) % count)])] - hull.vertices[at(loop[at(i)])];
    if (edge.squaredNorm() > longest.squaredNorm()) longest = edge;
  }
  const Vector3 along = longest / length(longest);
  const Vector3 unit = direction / direction.norm();
  const Vector3 square = unit - unit.dot(along) * along;
  hull.faces.push_back({square / square.norm(), 0, first, count});
}

void pairHalfEdges(ConvexHull& hull) {
  // A map, not a hash map: the edges are numbered in the same order on every machine.
  std::map<std::pair<Index, Index>, Index> byEnds;
  for (std::size_t i = 0; i < hull.halfEdges.size(); ++i) {
    const HullHalfEdge& side = hull.halfEdges[i];
    const Index end = hull.halfEdges[at(side.next)].origin;
    if (!byEnds.emplace(std::pair{side.origin, end}, static_cast<Index>(i)).second) {
      reject("edge from vertex " + std::to_string(side.origin), "to " + std::to_string(end),
             "must run once each way: two faces use it in the same direction");
    }
  }
  for (const auto& [ends, i] : byEnds) {
    const auto twin = byEnds.find({ends.second, ends.first});
    if (twin == byEnds.end()) {
      reject("edge from vertex " + std::to_string(ends.first), "to " + std::to_string(ends.second),
             "must have a face on both sides: the hull is open");
    }
    HullHalfEdge& side = hull.halfEdges[at(i)];
    HullHalfEdge& other = hull.halfEdges[at(twin->second)];
    side.twin = twin->second;
    if (ends.first < ends.second) {
      side.edge = other.edge = static_cast<Index>(hull.edges.size());
      hull.edges.push_back({ends.first, ends.second, side.face, other.face});
    }
  }
}

// Volume and centre of volume from the tetrahedra over the faces, seen from vertex 0.
void weigh(ConvexHull& hull) {
  const Vector3& origin = hull.vertices[0];
  Vector3 moment = Vector3::Zero();
  Real sixVolumes = 0;
  for (const HullFace& face : hull.faces) {
    const Vector3 a = hull.vertices[at(hull.halfEdges[at(face.firstHalfEdge)].origin)] - origin;
    for (Index i = face.firstHalfEdge + 1; i + 1 < face.firstHalfEdge + face.count; ++i) {
      const Vector3 b = hull.vertices[at(hull.halfEdges[at(i)].origin)] - origin;
      const Vector3 c = hull.vertices[at(hull.halfEdges[at(i + 1)].origin)] - origin;
      const Real determinant = a.dot(cross(b - a, c - a));
      sixVolumes += determinant;
      moment += determinant * (a + b + c);
    }
  }
  if (!(sixVolumes > 0)) {
    reject("volume of the hull", toText(sixVolumes / 6),
           "must be positive: corners of faces run counter-clockwise seen from outside");
  }
  hull.volume = sixVolumes / 6;
  hull.centroid = origin + moment / (4 * sixVolumes);
  for (const Vector3& v : hull.vertices) {
    hull.boundingRadius = std::max(hull.boundingRadius, length(v - hull.centroid));
  }
}

// Every corner on or below every plane, and the corners of a face on it.
void setOffsetsAndCheck(ConvexHull& hull, Real slack) {
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    HullFace& face = hull.faces[f];
    // Measured from a corner of the face, so that the check rounds with the size of the hull and
    // not with its distance from the origin.
    const Vector3& origin = hull.vertices[at(hull.halfEdges[at(face.firstHalfEdge)].origin)];
    Real low = 0, high = 0;
    for (Index i = face.firstHalfEdge; i < face.firstHalfEdge + face.count; ++i) {
      const Real height = face.normal.dot(hull.vertices[at(hull.halfEdges[at(i)].origin)] - origin);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    if (high - low > slack) {
      reject("face " + std::to_string(f), "corners " + toText(high - low) + " m off one plane",
             "must be flat");
    }
    face.offset = -std::numeric_limits<Real>::infinity();
    for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
      const Real height = face.normal.dot(hull.vertices[v] - origin);
      if (height > high + slack) {
        reject("vertex", vertexText(static_cast<Index>(v), hull.vertices[v]),
               "lies " + toText(height) + " m outside face " + std::to_string(f) +
                   ": the solid is not convex");
      }
      face.offset = std::max(face.offset, face.normal.dot(hull.vertices[v]));
    }
  }
}

}  // namespace

ConvexHull hullFromFaces(std::span<const Vector3> vertices,
                         std::span<const std::vector<std::int32_t>> faces, Real flatness) {
  ConvexHull hull;
  Real largest = 0;
  for (const Vector3& v : vertices) {
    requireCoordinates(v, "vertex of a hull");
    hull.vertices.push_back(v);
    hull.x.push_back(v.x());
    hull.y.push_back(v.y());
    hull.z.push_back(v.z());
    largest = std::max(largest, v.cwiseAbs().maxCoeff());
  }
  if (vertices.size() < 4 || faces.size() < 4) {
    reject(
        "hull",
        std::to_string(vertices.size()) + " vertices, " + std::to_string(faces.size()) + " faces",
        "must have at least 4 of each");
  }
  hull.anyHalfEdge.assign(vertices.size(), -1);
  for (const std::vector<std::int32_t>& loop : faces) addFace(hull, loop);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (hull.anyHalfEdge[v] < 0) {
      reject("vertex", vertexText(static_cast<Index>(v), vertices[v]), "must belong to a face");
    }
  }
  pairHalfEdges(hull);
  setOffsetsAndCheck(hull, flatness * largest);
  weigh(hull);
  return hull;
}

ConvexHull boxHull(const Vector3& halfExtents) {
  std::vector<Vector3> vertices;
  for (int k = 0; k < 3; ++k) requireLength(halfExtents(k), "half extent of a box");
  for (int i = 0; i < 8; ++i) {
    const auto sign = [i](int axis) { return ((i >> axis) & 1) != 0 ? 1.0 : -1.0; };
    vertices.emplace_back(sign(0) * halfExtents.x(), sign(1) * halfExtents.y(),
                          sign(2) * halfExtents.z());
  }
  const std::vector<std::vector<std::int32_t>> faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                        {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return hullFromFaces(vertices, faces);
}

}  // namespace carom
