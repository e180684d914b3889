#include "carom/world/ground.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <tuple>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/detection/limits.hpp"
#include "carom/mass/check_mesh.hpp"

namespace carom::world {

namespace {

std::size_t at(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

// A triangle's side, by its two vertices.
struct Side {
  std::int32_t low = 0, high = 0;  // vertices
  std::int32_t face = 0;
  int k = 0;  // number of the side in its triangle
  bool rising = false;
};

// All sides; those of one edge stand together.
std::vector<Side> sortedSides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t from = mesh.triangles[t][at(k)];
      const std::int32_t to = mesh.triangles[t][at((k + 1) % 3)];
      sides.push_back(
          {std::min(from, to), std::max(from, to), static_cast<std::int32_t>(t), k, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
    return std::tie(p.low, p.high, p.face) < std::tie(q.low, q.high, q.face);
  });
  return sides;
}

void requireEdge(std::span<const Side> same) {
  const std::string edge = "ground: edge " + std::to_string(same[0].low) + "-" +
                           std::to_string(same[0].high) + " of triangle " +
                           std::to_string(same[0].face);
  if (same.size() > 2) {
    throw InvalidInput(edge + " is not manifold: " + std::to_string(same.size()) +
                       " triangles share it");
  }
  if (same.size() == 2 && same[0].rising == same[1].rising) {
    throw InvalidInput(edge + " is passed in the same direction by triangle " +
                       std::to_string(same[1].face) + ": one of the two is flipped");
  }
}

// Into a face, square to one of its sides.
Vector3 inwardsOf(const Ground& ground, const GroundFace& face, int k) {
  const Vector3& from = ground.vertices[at(face.corners[at(k)])];
  const Vector3& to = ground.vertices[at(face.corners[at((k + 1) % 3)])];
  return cross(face.normal, (to - from).normalized());
}

// How the ground goes on from a face over its side k to another face.
EdgeKind kindOf(const Ground& ground, const GroundFace& face, int k, const GroundFace& other) {
  const Vector3& origin = ground.vertices[at(face.corners[at(k)])];
  Real height = 0, size = 0;
  for (const std::int32_t corner : other.corners) {
    const Vector3 way = ground.vertices[at(corner)] - origin;
    if (std::abs(face.normal.dot(way)) > std::abs(height)) height = face.normal.dot(way);
    size = std::max(size, way.norm());
  }
  // As flat as coordinates can say: some hundred roundings.
  constexpr Real kFlat = 1e-13;
  const Real rounding = kFlat * (size + origin.cwiseAbs().maxCoeff());
  if (std::abs(height) <= rounding && face.normal.dot(other.normal) > 0) return EdgeKind::flat;
  return height > 0 ? EdgeKind::valley : EdgeKind::ridge;
}

// The tangent of half the angle between two normals.
Real halfTangent(const Vector3& a, const Vector3& b) {
  constexpr Real kLargest = 1e3;  // of a knife
  const Real cosine = a.dot(b);
  if (!(1 + cosine > 0)) return kLargest;
  return std::min(kLargest, std::sqrt(std::max(Real(0), 1 - cosine) / (1 + cosine)));
}

void join(Ground& ground, std::span<const Side> same) {
  GroundFace& face = ground.faces[at(same[0].face)];
  const int k = same[0].k;
  EdgeKind kind = EdgeKind::rim;
  GroundEdge edge;
  edge.from = face.corners[at(k)];
  edge.to = face.corners[at((k + 1) % 3)];
  edge.inwards = inwardsOf(ground, face, k);
  edge.otherwise = -face.normal;
  if (same.size() == 2) {
    GroundFace& other = ground.faces[at(same[1].face)];
    kind = kindOf(ground, face, k, other);
    other.edges[at(same[1].k)] = kind;
    edge.otherwise = inwardsOf(ground, other, same[1].k);
    if (kind == EdgeKind::ridge) {
      face.lean[at(k)] = other.lean[at(same[1].k)] = halfTangent(face.normal, other.normal);
    }
  }
  face.edges[at(k)] = kind;
  if (kind == EdgeKind::ridge || kind == EdgeKind::rim) ground.edges.push_back(edge);
}

void makeRings(Ground& ground, std::span<const Side> sides) {
  ground.ringStart.assign(ground.vertices.size() + 1, 0);
  const auto isFirst = [&](std::size_t i) {
    return i == 0 || sides[i].low != sides[i - 1].low || sides[i].high != sides[i - 1].high;
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (!isFirst(i)) continue;
    ++ground.ringStart[at(sides[i].low) + 1];
    ++ground.ringStart[at(sides[i].high) + 1];
  }
  for (std::size_t v = 0; v < ground.vertices.size(); ++v) {
    ground.ringStart[v + 1] += ground.ringStart[v];
  }
  ground.ring.resize(at(ground.ringStart.back()));
  std::vector<std::int32_t> next(ground.ringStart.begin(), ground.ringStart.end() - 1);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (!isFirst(i)) continue;
    ground.ring[at(next[at(sides[i].low)]++)] = sides[i].high;
    ground.ring[at(next[at(sides[i].high)]++)] = sides[i].low;
  }
}

}  // namespace

Ground makeGround(const TriangleMesh& mesh) {
  requireUsable(mesh);
  for (const Vector3& vertex : mesh.vertices) requireCoordinates(vertex, "vertex of the ground");
  Ground ground;
  ground.vertices = mesh.vertices;
  ground.faces.reserve(mesh.triangles.size());
  for (const std::array<std::int32_t, 3>& triangle : mesh.triangles) {
    const Corners corners = cornersOf(mesh, triangle);
    const Vector3 u = corners.b - corners.a, v = corners.c - corners.a;
    GroundFace face;
    face.corners = triangle;
    face.normal = cross(u, v);
    const Real area = face.normal.norm(), sides = u.norm() * v.norm();
    // Thinner than this the normal has no digit left.
    constexpr Real kThin = 1e-14;
    if (!(area > kThin * sides)) {
      // The judge of meshes says it best; what it lets pass is thinner than we can use.
      const std::vector<MeshProblem> problems = checkMesh(mesh);
      if (!problems.empty() && problems[0].kind == MeshProblemKind::degenerateTriangle) {
        throw InvalidInput("ground: " + problems[0].message);
      }
      reject("triangle of the ground", std::to_string(ground.faces.size()),
             "is too thin to have a normal");
    }
    face.normal /= area;
    ground.faces.push_back(face);
  }
  const std::vector<Side> sides = sortedSides(mesh);
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first;
    while (last < sides.size() && sides[last].low == sides[first].low &&
           sides[last].high == sides[first].high) {
      ++last;
    }
    const std::span<const Side> same(sides.data() + first, last - first);
    requireEdge(same);
    join(ground, same);
    first = last;
  }
  makeRings(ground, sides);
  return ground;
}

int cornersOfItem(const Ground& ground, std::int32_t item, std::array<Vector3, 3>& corners) {
  if (ground.isFace(item)) {
    const GroundFace& face = ground.faces[at(item)];
    for (std::size_t k = 0; k < 3; ++k) corners[k] = ground.vertices[at(face.corners[k])];
    return 3;
  }
  const GroundEdge& edge = ground.edge(item);
  corners[0] = ground.vertices[at(edge.from)];
  corners[1] = ground.vertices[at(edge.to)];
  return 2;
}

Aabb<3> boundsOfItem(const Ground& ground, std::int32_t item, const Pose& pose) {
  std::array<Vector3, 3> corners;
  const int count = cornersOfItem(ground, item, corners);
  const Vector3 first = pointToWorld(pose, corners[0]);
  Aabb<3> box{first, first};
  for (int k = 1; k < count; ++k) {
    const Vector3 corner = pointToWorld(pose, corners[at(k)]);
    box.low = box.low.cwiseMin(corner);
    box.high = box.high.cwiseMax(corner);
  }
  return box;
}

void flatHull(const Ground& ground, std::int32_t item, ConvexHull& hull) {
  std::array<Vector3, 3> corners;
  cornersOfItem(ground, item, corners);
  const Vector3& normal = ground.faces[at(item)].normal;
  hull.vertices.assign(corners.begin(), corners.end());
  hull.x.clear(), hull.y.clear(), hull.z.clear();
  hull.centroid = (corners[0] + corners[1] + corners[2]) / 3;
  hull.boundingRadius = 0;
  for (const Vector3& corner : corners) {
    hull.x.push_back(corner.x());
    hull.y.push_back(corner.y());
    hull.z.push_back(corner.z());
    hull.boundingRadius = std::max(hull.boundingRadius, (corner - hull.centroid).norm());
  }
  const Real offset = normal.dot(corners[0]);
  hull.faces = {{normal, offset, 0, 3}, {-normal, -offset, 3, 3}};
  // Around the front 0, 1, 2; around the back 0, 2, 1. Edge k runs from corner k to the next.
  hull.halfEdges = {{0, 1, 5, 0, 0}, {1, 2, 4, 0, 1}, {2, 0, 3, 0, 2},
                    {0, 4, 2, 1, 2}, {2, 5, 1, 1, 1}, {1, 3, 0, 1, 0}};
  hull.edges = {{0, 1, 0, 1}, {1, 2, 0, 1}, {2, 0, 0, 1}};
  hull.anyHalfEdge = {0, 1, 2};
}

}  // namespace carom::world
