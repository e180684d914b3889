#include "carom/world/collide_ground.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/manifold/collide_balls.hpp"
#include "carom/manifold/collide_features.hpp"
#include "carom/manifold/facing_feature.hpp"
#include "carom/manifold/feature_name.hpp"
#include "carom/manifold/loop_manifold.hpp"

namespace carom::world {

namespace {

using carom::detail::ClipCorner;
using carom::detail::FacingFeature;
using carom::detail::ShapeView;

constexpr int kMost = FacingFeature::kMost + 3;
constexpr std::int32_t kSide = 1 << 20;  // labels of the face's sides follow

// A face in its own plane, seen from the body: x along u, y along v.
struct FacePlane {
  Vector3 normal, u, v;
  Real height = 0;  // of the body's origin
  std::array<Vector2, 3> corners;
  std::array<Vector2, 3> outwards;  // unit

  FacePlane(const Ground& ground, const GroundFace& face, const Pose& G, const Pose& B) {
    normal = G.R_WB * face.normal;
    const Vector3 axis = std::abs(normal.z()) < 0.5 ? Vector3::UnitZ() : Vector3::UnitX();
    u = cross(axis, normal).normalized();
    v = cross(normal, u);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& vertex = ground.vertices[static_cast<std::size_t>(face.corners[k])];
      const Vector3 corner = G.R_WB * vertex + (G.p_WB - B.p_WB);
      corners[k] = {corner.dot(u), corner.dot(v)};
      if (k == 0) height = -normal.dot(corner);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector2 along = (corners[(k + 1) % 3] - corners[k]).normalized();
      outwards[k] = {along.y(), -along.x()};
    }
  }

  // How far a corner is outside of a side; what is below belongs to the neighbour of a ridge.
  Real outside(const GroundFace& face, std::size_t k, const ClipCorner& c) const {
    return outwards[k].dot(Vector2(c.x, c.y) - corners[k]) +
           face.lean[k] * std::max(Real(0), -c.height);
  }

  bool isOver(const GroundFace& face, const ClipCorner& c, Real snap) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (outside(face, k, c) > snap) return false;
    }
    return true;
  }
};

// A line is no loop: its ends move to the cut, each in its place.
int clipLine(const FacePlane& plane, const GroundFace& face, Real snap, ClipCorner* line) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Real at0 = plane.outside(face, k, line[0]), at1 = plane.outside(face, k, line[1]);
    if (at0 > snap && at1 > snap) return 0;
    if (at0 <= snap && at1 <= snap) continue;
    const int moved = at0 > snap ? 0 : 1;
    const ClipCorner fixed = line[1 - moved];
    const Real here = moved == 0 ? at1 : at0, there = moved == 0 ? at0 : at1;
    const Real part = std::clamp(here / (here - there), Real(0), Real(1));
    line[moved] = {fixed.x + part * (line[moved].x - fixed.x),
                   fixed.y + part * (line[moved].y - fixed.y),
                   fixed.height + part * (line[moved].height - fixed.height),
                   kSide + static_cast<std::int32_t>(k)};
  }
  return 2;
}

// What of the body's feature is over the face. Returns how many corners; `out` receives them.
int clipFeature(const FacePlane& plane, const GroundFace& face, const FacingFeature& feature,
                Real snap, ClipCorner* out) {
  ClipCorner first[kMost], second[kMost];
  ClipCorner *loop = first, *spare = second;
  int count = feature.count;
  for (int k = 0; k < count; ++k) {
    const Vector3& corner = feature.corners[k];
    loop[k] = {corner.dot(plane.u), corner.dot(plane.v), plane.height + plane.normal.dot(corner),
               k};
  }
  if (count == 1) {
    if (!plane.isOver(face, loop[0], snap)) return 0;
  } else if (count == 2) {
    count = clipLine(plane, face, snap, loop);
  } else {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto outside = [&](const ClipCorner& c) { return plane.outside(face, k, c); };
      count = carom::detail::clipLoop(loop, count, kSide + static_cast<std::int32_t>(k), outside,
                                      snap, spare);
      std::swap(loop, spare);
    }
  }
  std::copy(loop, loop + count, out);
  return count;
}

// Names the corners that are left, and drops those which only the triangulation has made. Returns
// how many stay, in their order.
int keepCorners(const FacePlane& plane, const GroundFace& face, const FacingFeature& feature,
                Real snap, int count, ClipCorner* loop, std::uint32_t* names) {
  std::array<std::int32_t, kMost> labels;
  for (int i = 0; i < count; ++i) labels[static_cast<std::size_t>(i)] = loop[i].label;
  const auto isSide = [](std::int32_t label) { return label >= kSide; };
  const auto ends = [&](std::int32_t label) {
    return face.edges[static_cast<std::size_t>(label - kSide)] != EdgeKind::flat;
  };
  constexpr std::uint32_t kFace = static_cast<std::uint32_t>(FeatureKind::face) << 14;
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    const std::int32_t after = labels[static_cast<std::size_t>(i)];
    const std::int32_t before = labels[static_cast<std::size_t>(i > 0 ? i - 1 : count - 1)];
    // A corner of the body stays, also if it lies on a side.
    int own = -1;
    for (int k = 0; k < feature.count && own < 0; ++k) {
      const Vector3& corner = feature.corners[k];
      const Real dx = corner.dot(plane.u) - loop[i].x, dy = corner.dot(plane.v) - loop[i].y;
      if (std::abs(dx) <= snap && std::abs(dy) <= snap) own = k;
    }
    std::uint32_t name = 0;
    if (own >= 0) {
      name = (kFace << 16) | feature.cornerNames[own];
    } else if (feature.count == 2) {
      if (!ends(after)) continue;
      name = (carom::detail::nameOf(FeatureKind::edge, after - kSide) << 16) | feature.edgeNames[0];
    } else if (isSide(before) && isSide(after)) {
      if (!ends(before) && !ends(after)) continue;
      name = (carom::detail::nameOf(FeatureKind::vertex, after - kSide) << 16) | feature.faceName;
    } else if (isSide(before) || isSide(after)) {
      const std::int32_t side = std::max(before, after), edge = std::min(before, after);
      if (!ends(side)) continue;
      name =
          (carom::detail::nameOf(FeatureKind::edge, side - kSide) << 16) | feature.edgeNames[edge];
    } else {
      name = (kFace << 16) | feature.cornerNames[after];
    }
    loop[kept] = loop[i];
    loop[kept].label = kept;
    names[kept++] = name;
  }
  return kept;
}

Manifold collideFace(const Ground& ground, const GroundFace& face, const Pose& G,
                     const ShapeView& b, const Pose& B, Real margin) {
  Manifold manifold;
  const FacePlane plane(ground, face, G, B);
  manifold.normal = plane.normal;
  const Vector3 down_B = -(B.R_WB.transpose() * plane.normal);
  const Vector3 lowest = B.R_WB * carom::detail::supportOfView(b, down_B);
  const Real separation = plane.height + plane.normal.dot(lowest);
  if (separation > margin) return manifold;
  const Vector3 highest = B.R_WB * carom::detail::supportOfView(b, -down_B);
  if (plane.height + plane.normal.dot(lowest + highest) / 2 <= 0) return manifold;

  FacingFeature feature;
  carom::detail::facingFeature(b, B.R_WB, Vector3::Zero(), -plane.normal, feature);
  const Real reach = std::abs(plane.height) + lowest.cwiseAbs().sum();
  // Where a side is, to some rounding of the largest number that enters.
  constexpr Real kRounding = 64 * std::numeric_limits<Real>::epsilon();
  const Real snap =
      kRounding * (reach + plane.corners[0].cwiseAbs().maxCoeff() + B.p_WB.cwiseAbs().maxCoeff());
  ClipCorner loop[kMost];
  const int count = clipFeature(plane, face, feature, snap, loop);
  Real least = std::numeric_limits<Real>::infinity();
  for (int i = 0; i < count; ++i) least = std::min(least, loop[i].height);
  const ClipCorner deepest{lowest.dot(plane.u), lowest.dot(plane.v), separation, 0};
  const bool deepestIsOver = plane.isOver(face, deepest, snap);
  if (deepestIsOver) least = std::min(least, separation);
  // What is behind the plane somewhere else does not touch this face; but for a little, because a
  // body that lies flat dips in at one corner before the others.
  constexpr Real kDip = 1e-5;
  if (separation < -kDip * reach && separation < least - kDip * reach) return manifold;

  std::uint32_t names[kMost];
  const int kept = keepCorners(plane, face, feature, snap, count, loop, names);
  constexpr Real kTie = 1e-12;  // corners that are as deep as the deepest but for rounding
  const Real limit = std::max(margin, separation + kTie * reach);
  const carom::detail::ReferencePlane reference{B.p_WB - plane.height * plane.normal, plane.u,
                                                plane.v, plane.normal};
  const auto name = [&](std::int32_t, std::int32_t corner) { return names[corner]; };
  if (kept > 0) carom::detail::fillFromLoop(reference, loop, kept, limit, name, manifold);
  if (deepestIsOver) {
    const std::uint32_t id = (carom::detail::nameOf(FeatureKind::face, 0) << 16) |
                             carom::detail::nameOf(FeatureKind::surface, 0);
    carom::detail::keepDeepest(B.p_WB + lowest - separation / 2 * plane.normal, separation, reach,
                               id, manifold);
  }
  return manifold;
}

// The rotation whose third column is a direction.
Matrix3 frameAlong(const Vector3& direction) {
  int least = 0;
  direction.cwiseAbs().minCoeff(&least);
  const Vector3 x = cross(Vector3(Vector3::Unit(least)), direction).normalized();
  Matrix3 R;
  R << x, cross(direction, x), direction;
  return R;
}

Pose poseOfEdge(const Ground& ground, const GroundEdge& edge, const Pose& G) {
  const Vector3& from = ground.vertices[static_cast<std::size_t>(edge.from)];
  const Vector3& to = ground.vertices[static_cast<std::size_t>(edge.to)];
  return {G.R_WB * frameAlong((to - from).normalized()), pointToWorld(G, (from + to) / 2)};
}

// Whether a vertex has a normal: no edge of the ground comes up along it.
bool hasNormal(const Ground& ground, std::int32_t vertex, const Vector3& normal, Real slack) {
  const std::size_t v = static_cast<std::size_t>(vertex);
  for (std::int32_t i = ground.ringStart[v]; i < ground.ringStart[v + 1]; ++i) {
    const std::size_t other = static_cast<std::size_t>(ground.ring[static_cast<std::size_t>(i)]);
    const Vector3 along = (ground.vertices[other] - ground.vertices[v]).normalized();
    if (normal.dot(along) > slack) return false;
  }
  return true;
}

Manifold collideEdge(const Ground& ground, const GroundEdge& edge, const Pose& G,
                     const ConvexShape& b, const Pose& B, Real margin) {
  const Vector3& from = ground.vertices[static_cast<std::size_t>(edge.from)];
  const Vector3& to = ground.vertices[static_cast<std::size_t>(edge.to)];
  const Vector3 way = to - from, along = way.normalized();
  const Capsule line{0, way.norm() / 2};
  const Pose E = poseOfEdge(ground, edge, G);
  const Ball* ball = std::get_if<Ball>(&b);
  Manifold manifold = ball != nullptr ? carom::detail::collideWithBallOf(&line, E, *ball, B, margin)
                                      : carom::detail::collideFeaturesOf(
                                            &line, E, carom::detail::viewOfShape(b), B, margin);
  if (manifold.count == 0) return manifold;
  const Vector3 normal = G.R_WB.transpose() * manifold.normal;
  // Normals of round bodies are right to rounding; a line on a face may be off by what GJK leaves.
  const bool round = manifold.count == 1;
  const Real slack = round ? 1e-9 : 1e-6;
  bool counts = normal.dot(edge.inwards) <= slack && normal.dot(edge.otherwise) <= slack;
  // Beyond an end it is the vertex that is touched. A line in touch may lean a little.
  const Real lean = normal.dot(along), most = round ? 1e-9 : 1e-3;
  if (counts && lean > most) counts = hasNormal(ground, edge.to, normal, most);
  if (counts && lean < -most) counts = hasNormal(ground, edge.from, normal, most);
  if (!counts) manifold.count = 0;
  return manifold;
}

}  // namespace

Manifold collideGround(const Ground& ground, std::int32_t item, const Pose& G, const ConvexShape& b,
                       const Pose& B, Real margin) {
  if (!ground.isFace(item)) return collideEdge(ground, ground.edge(item), G, b, B, margin);
  const GroundFace& face = ground.faces[static_cast<std::size_t>(item)];
  return collideFace(ground, face, G, carom::detail::viewOfShape(b), B, margin);
}

Pose edgePose(const Ground& ground, std::int32_t item, const Pose& G) {
  return poseOfEdge(ground, ground.edge(item), G);
}

Real heightOverFace(const Ground& ground, std::int32_t item, const Pose& G, const ConvexShape& b,
                    const Pose& B) {
  const GroundFace& face = ground.faces[static_cast<std::size_t>(item)];
  const Vector3 normal = G.R_WB * face.normal;
  const Vector3& vertex = ground.vertices[static_cast<std::size_t>(face.corners[0])];
  const Vector3 corner = G.R_WB * vertex + (G.p_WB - B.p_WB);
  const Vector3 down_B = -(B.R_WB.transpose() * normal);
  return normal.dot(B.R_WB * supportOf(b, down_B).point) - normal.dot(corner);
}

RayHit castRayAtFace(const Ground& ground, std::int32_t item, const Pose& G, const Ray& ray) {
  RayHit hit;
  const GroundFace& face = ground.faces[static_cast<std::size_t>(item)];
  const Vector3 normal = G.R_WB * face.normal;
  std::array<Vector3, 3> corners;
  cornersOfItem(ground, item, corners);
  for (Vector3& corner : corners) corner = pointToWorld(G, corner) - ray.origin;
  // Scaled, so that directions of any length can be squared.
  const Real whole = ray.direction.stableNorm();
  const Vector3 direction = ray.direction / whole;
  const Real height = -normal.dot(corners[0]), fall = -normal.dot(direction);
  if (fall == 0) return hit;
  const Real way = height / fall;
  if (!(way >= 0) || way / whole > ray.reach) return hit;
  // The same sign for both triangles at an edge, so that no ray slips through between them: the
  // volume that the ray and the edge span.
  bool left = false, right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 &p = corners[k], &q = corners[(k + 1) % 3];
    const bool ordered = face.corners[k] < face.corners[(k + 1) % 3];
    const Real volume = ordered ? direction.dot(cross(p, q)) : -direction.dot(cross(q, p));
    left = left || volume > 0;
    right = right || volume < 0;
  }
  if (left && right) return hit;
  hit.hit = true;
  hit.t = way / whole;
  hit.point = ray.origin + hit.t * ray.direction;
  hit.normal = fall > 0 ? normal : Vector3(-normal);
  return hit;
}

}  // namespace carom::world
