#include "carom/manifold/collide_planar.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "carom/core/checks.hpp"
#include "carom/detection/closest_point.hpp"
#include "carom/detection/separating_axis.hpp"
#include "carom/manifold/feature_name.hpp"
#include "carom/manifold/swap_manifold.hpp"

namespace carom {
namespace {

using detail::nameOf;

void setPoint(const Vector2& normal, const Vector2& middle, Real separation, Manifold& manifold) {
  manifold.normal = {normal.x(), normal.y(), 0};
  manifold.count = 1;
  manifold.points[0].position = {middle.x(), middle.y(), 0};
  manifold.points[0].separation = separation;
  manifold.points[0].id = 0;
  manifold.areaCentroid = manifold.points[0].position;
}

// A figure and a disc; the normal points to the disc.
Manifold withDisc(const ConvexPlanarShape& a, const PlanarPose& A, const Disc& disc,
                  const PlanarPose& B, Real margin) {
  Manifold manifold;
  Vector2 normal, point;
  Real separation = 0;
  if (const Disc* other = std::get_if<Disc>(&a)) {
    const Vector2 between = B.p_WB - A.p_WB;
    const Real distance = between.stableNorm();
    normal = distance > 0 ? Vector2(between / distance) : Vector2(Vector2::UnitY());
    point = A.p_WB + other->radius * normal;
    separation = distance - (other->radius + disc.radius);
  } else {
    const OutlinePoint nearest = closestPoint(PlanarShape(std::get<Polygon>(a)), A, B.p_WB);
    normal = nearest.normal;
    point = nearest.point;
    separation = nearest.distance - disc.radius;
  }
  if (separation <= margin) setPoint(normal, point + separation / 2 * normal, separation, manifold);
  return manifold;
}

// The edge on which two polygons are farthest apart.
struct BestEdge {
  Real gap = 0;
  std::size_t edge = 0;
  Real length = 0;
};

// Gaps on the edges of `a`, in its frame. `pose` is that of b in the frame of a.
std::vector<Real> gapsOnEdges(const Polygon& a, const Polygon& b, const PlanarPose& pose) {
  std::vector<Real> gaps;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    Real gap = 0;
    for (std::size_t k = 0; k < b.vertices.size(); ++k) {
      const Vector2 corner = pointToWorld(pose, b.vertices[k]);
      const Real height = a.normals[i].dot(corner - a.vertices[i]);
      gap = k == 0 ? height : std::min(gap, height);
    }
    gaps.push_back(gap);
  }
  return gaps;
}

Real edgeLength(const Polygon& polygon, std::size_t i) {
  return (polygon.vertices[(i + 1) % polygon.vertices.size()] - polygon.vertices[i]).norm();
}

// Of the edges within a tie of the best the longest, then the first.
BestEdge bestEdge(const Polygon& polygon, const std::vector<Real>& gaps, Real tie) {
  const Real most = *std::max_element(gaps.begin(), gaps.end());
  BestEdge best;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i] < most - tie) continue;
    const Real length = edgeLength(polygon, i);
    if (length > best.length * (1 + kAxisTie)) best = {gaps[i], i, length};
  }
  return best;
}

Real reachOf(const Polygon& polygon) {
  Real reach = 0;
  for (const Vector2& corner : polygon.vertices) reach = std::max(reach, corner.norm());
  return reach;
}

// The reference edge belongs to `reference`; the normal of the result points out of it.
void cutEdge(const Polygon& reference, const PlanarPose& R, std::size_t edge,
             const Polygon& incident, const PlanarPose& relative, Real limit, Real snap,
             Manifold& manifold) {
  // The incident edge looks most against the normal; the first of equal ones.
  const Vector2& normal = reference.normals[edge];
  std::size_t against = 0;
  Real least = 2;
  for (std::size_t k = 0; k < incident.normals.size(); ++k) {
    const Real along = directionToWorld(relative, incident.normals[k]).dot(normal);
    if (along < least - kAxisTie) {
      least = along;
      against = k;
    }
  }
  const std::size_t next = (against + 1) % incident.vertices.size();
  const Vector2& start = reference.vertices[edge];
  const std::size_t afterEdge = (edge + 1) % reference.vertices.size();
  const Real width = edgeLength(reference, edge);
  const Vector2 along(-normal.y(), normal.x());  // from the edge's start to its end

  // Both ends: how far along the reference edge, how high over it.
  struct End {
    Real along, height;
    std::uint32_t ofReference, ofIncident;
  };
  const auto endOf = [&](std::size_t vertex) -> End {
    const Vector2 corner = pointToWorld(relative, incident.vertices[vertex]) - start;
    return {corner.dot(along), corner.dot(normal), nameOf(FeatureKind::edge, edge),
            nameOf(FeatureKind::vertex, vertex)};
  };
  End ends[2] = {endOf(against), endOf(next)};
  const auto cut = [&](Real at, Real sign, std::size_t corner) {
    // Ends that coincide with the corner but for rounding stay as they are, and keep their names.
    const Real over0 = sign * (ends[0].along - at), over1 = sign * (ends[1].along - at);
    if (over0 <= snap && over1 <= snap) return;
    if (over0 > 0 && over1 > 0) {
      // Beyond the end altogether, by rounding: both ends go to the nearer one.
      ends[over0 < over1 ? 1 : 0] = ends[over0 < over1 ? 0 : 1];
      return;
    }
    End& outside = ends[over0 > 0 ? 0 : 1];
    const End& inside = ends[over0 > 0 ? 1 : 0];
    const Real part = (at - inside.along) / (outside.along - inside.along);
    outside = {at, inside.height + part * (outside.height - inside.height),
               nameOf(FeatureKind::vertex, corner), nameOf(FeatureKind::edge, against)};
  };
  cut(0, -1, edge);
  cut(width, 1, afterEdge);

  const Vector2 out = directionToWorld(R, normal);
  manifold.normal = {out.x(), out.y(), 0};
  const bool same = ends[0].along == ends[1].along && ends[0].height == ends[1].height;
  for (int k = 0; k < (same ? 1 : 2); ++k) {
    if (ends[k].height > limit) continue;
    const Vector2 middle =
        pointToWorld(R, start + ends[k].along * along + ends[k].height / 2 * normal);
    ManifoldPoint& point = manifold.points[manifold.count++];
    point.position = {middle.x(), middle.y(), 0};
    point.separation = ends[k].height;
    point.id = (ends[k].ofReference << 16) | ends[k].ofIncident;
  }
  if (manifold.count > 0) {
    manifold.areaCentroid =
        (manifold.points[0].position + manifold.points[manifold.count - 1].position) / 2;
  }
}

Manifold collidePolygons(const Polygon& a, const PlanarPose& A, const Polygon& b,
                         const PlanarPose& B, Real margin) {
  Manifold manifold;
  const PlanarPose bInA = relativePose(A, B), aInB = relativePose(B, A);
  const Real tie = kAxisTie * (reachOf(a) + reachOf(b));
  const BestEdge onA = bestEdge(a, gapsOnEdges(a, b, bInA), tie);
  const BestEdge onB = bestEdge(b, gapsOnEdges(b, a, aInB), tie);
  const Real separation = std::max(onA.gap, onB.gap);
  if (separation > margin) return manifold;
  const bool tied = std::abs(onA.gap - onB.gap) <= tie;
  // By gap, then by length, then by a rule that rounding does not sway.
  const bool alike = tied && std::abs(onA.length - onB.length) <= kAxisTie * onA.length;
  const Vector2 out = directionToWorld(A, a.normals[onA.edge]);
  const bool ofA = alike  ? tieScore({out.x(), out.y(), 0}) >= 0
                   : tied ? onA.length > onB.length
                          : onA.gap > onB.gap;
  const Real limit = std::max(margin, separation + tie);
  if (ofA) {
    cutEdge(a, A, onA.edge, b, bInA, limit, tie, manifold);
  } else {
    cutEdge(b, B, onB.edge, a, aInB, limit, tie, manifold);
    detail::swapBodies(manifold);
  }
  return manifold;
}

// Whether a pair is to be treated as (b, a): discs first, then by position and angle.
bool comesSecond(const ConvexPlanarShape& a, const PlanarPose& A, const ConvexPlanarShape& b,
                 const PlanarPose& B) {
  if (a.index() != b.index()) return a.index() > b.index();
  if (const int order = comparePoses(A, B); order != 0) return order > 0;
  const Polygon* polygonA = std::get_if<Polygon>(&a);
  const Polygon* polygonB = std::get_if<Polygon>(&b);
  if (polygonA == nullptr || polygonB == nullptr) return false;
  if (polygonA->vertices.size() != polygonB->vertices.size()) {
    return polygonA->vertices.size() > polygonB->vertices.size();
  }
  for (std::size_t i = 0; i < polygonA->vertices.size(); ++i) {
    for (int k = 0; k < 2; ++k) {
      const Real ofA = polygonA->vertices[i][k], ofB = polygonB->vertices[i][k];
      if (ofA != ofB) return ofA > ofB;
    }
  }
  return false;
}

}  // namespace

Manifold collidePlanar(const ConvexPlanarShape& a, const PlanarPose& A, const ConvexPlanarShape& b,
                       const PlanarPose& B, Real margin) {
  if (comesSecond(a, A, b, B)) {
    Manifold manifold = collidePlanar(b, B, a, A, margin);
    detail::swapBodies(manifold);
    return manifold;
  }
  // Discs are the first kind, so a pair with a disc has it as A.
  if (const Disc* disc = std::get_if<Disc>(&a)) {
    Manifold manifold = withDisc(b, B, *disc, A, margin);
    detail::swapBodies(manifold);
    return manifold;
  }
  return collidePolygons(std::get<Polygon>(a), A, std::get<Polygon>(b), B, margin);
}

namespace {

std::vector<PlanarCompoundPart> partsOf(const PlanarShape& shape) {
  if (const PlanarCompound* compound = std::get_if<PlanarCompound>(&shape)) return compound->parts;
  if (const Disc* disc = std::get_if<Disc>(&shape)) return {{*disc, PlanarPose()}};
  return {{std::get<Polygon>(shape), PlanarPose()}};
}

}  // namespace

void collidePlanar(const PlanarShape& a, const PlanarPose& A, const PlanarShape& b,
                   const PlanarPose& B, std::vector<PartManifold>& manifolds, Real margin) {
  requireNonNegative(margin, "margin of collidePlanar");
  manifolds.clear();
  const std::vector<PlanarCompoundPart> partsA = partsOf(a), partsB = partsOf(b);
  for (std::size_t i = 0; i < partsA.size(); ++i) {
    for (std::size_t j = 0; j < partsB.size(); ++j) {
      const Manifold manifold = collidePlanar(partsA[i].shape, composed(A, partsA[i].pose),
                                              partsB[j].shape, composed(B, partsB[j].pose), margin);
      if (manifold.count > 0) {
        manifolds.push_back({static_cast<int>(i), static_cast<int>(j), manifold});
      }
    }
  }
}

}  // namespace carom
