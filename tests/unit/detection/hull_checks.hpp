#pragma once
// What every hull must be, checked from its definition.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "carom/core/cross.hpp"
#include "carom/detection/convex_hull.hpp"
#include "support/catch.hpp"

namespace carom_test {

// Euler's formula, links that close, planes that hold every corner, faces that are flat, normals
// of length one that look outwards.
inline void checkHull(const carom::ConvexHull& hull) {
  using carom::Real;
  using carom::Vector3;
  const auto at = [](std::int32_t i) { return static_cast<std::size_t>(i); };
  CHECK(hull.vertices.size() + hull.faces.size() == hull.edges.size() + 2);
  CHECK(hull.halfEdges.size() == 2 * hull.edges.size());
  Real largest = 0;
  for (const Vector3& v : hull.vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());

  std::size_t badLinks = 0;
  for (std::size_t i = 0; i < hull.halfEdges.size(); ++i) {
    const carom::HullHalfEdge& side = hull.halfEdges[i];
    const carom::HullHalfEdge& twin = hull.halfEdges[at(side.twin)];
    const carom::HullHalfEdge& next = hull.halfEdges[at(side.next)];
    badLinks += at(twin.twin) != i || twin.edge != side.edge || twin.face == side.face;
    badLinks += next.face != side.face || twin.origin != next.origin;
    const carom::HullEdge& edge = hull.edges[at(side.edge)];
    const bool forward = edge.from == side.origin;
    badLinks += (forward ? edge.leftFace : edge.rightFace) != side.face;
    badLinks += (forward ? edge.to : edge.from) != next.origin;
  }
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    badLinks += at(hull.halfEdges[at(hull.anyHalfEdge[v])].origin) != v;
    badLinks += Vector3(hull.x[v], hull.y[v], hull.z[v]) != hull.vertices[v];
  }
  CHECK(badLinks == 0);

  Real farthest = 0, worstNormal = 0, worstOutside = 0, worstFlatness = 0, leastTurn = 1;
  for (const carom::HullFace& face : hull.faces) {
    worstNormal = std::max(worstNormal, std::abs(face.normal.norm() - 1));
    for (const Vector3& v : hull.vertices) {
      worstOutside = std::max(worstOutside, face.normal.dot(v) - face.offset);
    }
    for (std::int32_t k = 0; k < face.count; ++k) {
      const Vector3& a = hull.vertices[at(hull.halfEdges[at(face.firstHalfEdge + k)].origin)];
      const Vector3& b =
          hull.vertices[at(hull.halfEdges[at(face.firstHalfEdge + (k + 1) % face.count)].origin)];
      const Vector3& c =
          hull.vertices[at(hull.halfEdges[at(face.firstHalfEdge + (k + 2) % face.count)].origin)];
      worstFlatness = std::max(worstFlatness, std::abs(face.normal.dot(a) - face.offset));
      leastTurn = std::min(leastTurn, face.normal.dot(carom::cross(b - a, c - b)));
    }
  }
  for (const Vector3& v : hull.vertices) farthest = std::max(farthest, (v - hull.centroid).norm());
  CHECK(worstNormal <= 1e-15);
  CHECK(worstOutside <= 4e-16 * largest);
  CHECK(worstFlatness <= 4 * carom::kFlatness * largest);
  CHECK(leastTurn > 0);
  CHECK(farthest <= hull.boundingRadius * (1 + 1e-15));
  CHECK(hull.volume > 0);
}

}  // namespace carom_test
