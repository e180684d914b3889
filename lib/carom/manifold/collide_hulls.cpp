#include "carom/manifold/collide_hulls.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/variant.hpp"
#include "carom/detection/hull_axes.hpp"
#include "carom/detection/separate_hulls.hpp"
#include "carom/manifold/clip_loop.hpp"
#include "carom/manifold/feature_name.hpp"
#include "carom/manifold/loop_manifold.hpp"
#include "carom/manifold/plain_manifold.hpp"
#include "carom/manifold/swap_manifold.hpp"

namespace carom {
namespace {

using detail::ClipCorner;
using detail::HullAxis;
using detail::HullHint;
using detail::HullPair;
using detail::HullView;
using detail::nameOf;

// Two faces closer than this to the normal (8 degrees) are clipped although edges cross.
constexpr Real kNearlyFlat = 0.99;
// Labels of the sides of the reference face start here; those of the incident face at 0.
constexpr std::int32_t kReference = 1 << 20;

// Of the faces around a vertex the one that looks most against a direction [frame of the hull].
int faceAgainst(const HullView& hull, int vertex, const Vector3& direction) {
  const int first = hull.anyHalfEdge[vertex];
  int side = first;
  int best = -1;
  Real least = 0;
  do {
    const int f = hull.halfEdges[side].face;
    const Real along = hull.faces[f].normal.dot(direction);
    const bool tie = best >= 0 && std::abs(along - least) <= kAxisTie;
    if (best < 0 || (tie ? f < best : along < least)) {
      best = f;
      least = along;
    }
    side = hull.halfEdges[hull.halfEdges[side].twin].next;
  } while (side != first);
  return best;
}

// One face of each body: clips the incident one by the sides of the reference face.
// `normal` points from A to B [frame of A]; `alongFace` says that it is the reference face's own.
void fillFromFaces(const HullPair& pair, const Pose& A, bool ofA, int referenceFace,
                   int incidentFace, const Vector3& normal, bool alongFace, Real limit,
                   Manifold& manifold) {
  const HullView& reference = ofA ? pair.a : pair.b;
  const HullView& incident = ofA ? pair.b : pair.a;
  const HullFace& face = reference.faces[referenceFace];
  const HullFace& other = incident.faces[incidentFace];
  const auto toA = [&](bool bodyA, const Vector3& x) -> Vector3 {
    return bodyA ? x : Vector3(pair.R * x + pair.t);
  };

  // The reference plane: x along its first edge.
  const int sides = std::min(face.count, detail::kMostCorners / 2);
  const HullHalfEdge* side = reference.halfEdges + face.firstHalfEdge;
  const Vector3 origin = toA(ofA, reference.vertices[side[0].origin]);
  const Vector3 out = ofA ? face.normal : Vector3(pair.R * face.normal);
  const Vector3 u = (toA(ofA, reference.vertices[side[1].origin]) - origin).normalized();
  const Vector3 v = cross(out, u);
  const Vector3 away = ofA ? normal : Vector3(-normal);
  const detail::Shear shear = alongFace ? detail::Shear() : detail::Shear(out, u, v, away);

  // The incident face over it.
  ClipCorner first[detail::kMostCorners], second[detail::kMostCorners];
  ClipCorner* loop = first;
  ClipCorner* spare = second;
  int count = std::min(other.count, detail::kMostCorners / 2);
  for (int k = 0; k < count; ++k) {
    const HullHalfEdge& edge = incident.halfEdges[other.firstHalfEdge + k];
    const Vector3 place = toA(!ofA, incident.vertices[edge.origin]);
    const Vector3 corner = place - origin;
    // Heights over the plane as it is stored, not over one rounded corner of it.
    const Real height = ofA ? out.dot(place) - face.offset : out.dot(place - pair.t) - face.offset;
    first[k] = shear({corner.dot(u), corner.dot(v), height, k});
  }
  const ClipCorner* deepest = std::min_element(
      first, first + count,
      [](const ClipCorner& p, const ClipCorner& q) { return p.height < q.height; });
  const ClipCorner lowest = *deepest;

  // Cut by its sides.
  Vector3 from = Vector3::Zero();
  for (int i = 0; i < sides; ++i) {
    const Vector3 to =
        toA(ofA, reference.vertices[side[i + 1 < face.count ? i + 1 : 0].origin]) - origin;
    const Real x = from.dot(u), y = from.dot(v);
    const Real dx = to.dot(u) - x, dy = to.dot(v) - y;
    const auto outside = [=](const ClipCorner& c) { return (c.x - x) * dy - (c.y - y) * dx; };
    // outside() measures in multiples of the side's length.
    const Real snap = kAxisTie * pair.size * (std::abs(dx) + std::abs(dy));
    bool cuts = false;
    for (int k = 0; k < count; ++k) cuts |= outside(loop[k]) > snap;
    if (cuts) {
      count = detail::clipLoop(loop, count, kReference + i, outside, snap, spare);
      std::swap(loop, spare);
    }
    from = to;
  }

  // A corner is named by the edges that meet in it.
  const auto idOf = [ofA](std::uint32_t ofReference, std::uint32_t ofIncident) {
    return ofA ? (ofReference << 16) | ofIncident : (ofIncident << 16) | ofReference;
  };
  const auto name = [&](std::int32_t before, std::int32_t after) -> std::uint32_t {
    const auto incidentEdge = [&](std::int32_t k) {
      return incident.halfEdges[other.firstHalfEdge + k];
    };
    if (before < kReference && after < kReference) {
      return idOf(nameOf(FeatureKind::face, referenceFace),
                  nameOf(FeatureKind::vertex, incidentEdge(after).origin));
    }
    if (before >= kReference && after >= kReference) {
      // The vertex between two neighbouring sides: where the later one starts.
      const int i = before - kReference, j = after - kReference;
      const int start = (i + 1) % face.count == j ? j : i;
      return idOf(nameOf(FeatureKind::vertex, side[start].origin),
                  nameOf(FeatureKind::face, incidentFace));
    }
    return idOf(nameOf(FeatureKind::edge, side[std::max(before, after) - kReference].edge),
                nameOf(FeatureKind::edge, incidentEdge(std::min(before, after)).edge));
  };
  const detail::ReferencePlane plane{pointToWorld(A, origin), A.R_WB * u, A.R_WB * v,
                                     A.R_WB * away};
  detail::fillFromLoop(plane, loop, count, limit, name, manifold);
  if (manifold.count == 0 && alongFace) {
    // Two corners that just meet: rounding has cut the deepest one off. It is put back.
    detail::fillFromLoop(plane, &lowest, 1, lowest.height, name, manifold);
  }
}

// The point where an edge of A crosses an edge of B.
void fillFromEdges(const HullPair& pair, const Pose& A, const HullAxis& axis, Manifold& manifold) {
  const HullEdge& edgeA = pair.a.edges[axis.featureA];
  const HullEdge& edgeB = pair.b.edges[axis.featureB];
  const Vector3 start = pair.a.vertices[edgeA.from];
  const Vector3 u = pair.a.vertices[edgeA.to] - start;
  const Vector3 v = pair.R * (pair.b.vertices[edgeB.to] - pair.b.vertices[edgeB.from]);
  const Vector3 between = pair.R * pair.b.vertices[edgeB.from] + pair.t - start;
  const Vector3 perpendicular = cross(u, v);
  const Real square = perpendicular.squaredNorm();  // not zero: the edges have been tried
  const Real s = std::clamp(cross(between, v).dot(perpendicular) / square, Real(0), Real(1));
  const Real t = std::clamp(cross(between, u).dot(perpendicular) / square, Real(0), Real(1));
  const Vector3 fromAToB = between + t * v - s * u;

  manifold.count = 1;
  ManifoldPoint& point = manifold.points[0];
  point.position = pointToWorld(A, start + s * u + fromAToB / 2);
  point.separation = fromAToB.dot(axis.normal);
  point.id =
      (nameOf(FeatureKind::edge, axis.featureA) << 16) | nameOf(FeatureKind::edge, axis.featureB);
  manifold.area = 0;
  manifold.areaCentroid = point.position;
}

void fill(const HullPair& pair, const Pose& A, const HullAxis& axis, Real margin,
          Manifold& manifold) {
  manifold.normal = A.R_WB * axis.normal;
  // Corners within rounding of the deepest one count also where a margin of zero would drop them.
  const Real limit = std::max(margin, axis.separation + kAxisTie * pair.size);
  if (axis.kind == AxisKind::faceOfA) {
    const int incident = faceAgainst(pair.b, axis.featureB, pair.R.transpose() * axis.normal);
    fillFromFaces(pair, A, true, axis.featureA, incident, axis.normal, true, limit, manifold);
    return;
  }
  if (axis.kind == AxisKind::faceOfB) {
    const int incident = faceAgainst(pair.a, axis.featureA, -axis.normal);
    fillFromFaces(pair, A, false, axis.featureB, incident, axis.normal, true, limit, manifold);
    return;
  }
  // Faces beside the edges that are nearly perpendicular to the normal.
  const HullEdge& edgeA = pair.a.edges[axis.featureA];
  const HullEdge& edgeB = pair.b.edges[axis.featureB];
  const Vector3 normal_B = pair.R.transpose() * axis.normal;
  const Real leftA = pair.a.faces[edgeA.leftFace].normal.dot(axis.normal);
  const Real rightA = pair.a.faces[edgeA.rightFace].normal.dot(axis.normal);
  const Real leftB = -pair.b.faces[edgeB.leftFace].normal.dot(normal_B);
  const Real rightB = -pair.b.faces[edgeB.rightFace].normal.dot(normal_B);
  const Real flatA = std::max(leftA, rightA), flatB = std::max(leftB, rightB);
  if (flatA > kNearlyFlat && flatB > kNearlyFlat) {
    const int faceA = leftA >= rightA ? edgeA.leftFace : edgeA.rightFace;
    const int faceB = leftB >= rightB ? edgeB.leftFace : edgeB.rightFace;
    const bool tie = std::abs(flatA - flatB) <= kAxisTie;
    const bool ofA = tie ? tieScore(manifold.normal) >= 0 : flatA > flatB;
    fillFromFaces(pair, A, ofA, ofA ? faceA : faceB, ofA ? faceB : faceA, axis.normal, false, limit,
                  manifold);
    if (manifold.count > 0) return;
  }
  fillFromEdges(pair, A, axis, manifold);
}

// The cache knows the bodies in the order of the arguments, the search in an order of its own.
HullHint swapped(const HullHint& hint) {
  const AxisKind kind = hint.kind == AxisKind::faceOfA   ? AxisKind::faceOfB
                        : hint.kind == AxisKind::faceOfB ? AxisKind::faceOfA
                                                         : AxisKind::edges;
  return {kind, hint.featureB, hint.featureA};
}

Manifold collideViews(const HullView& a, const Pose& A, const HullView& b, const Pose& B,
                      ManifoldCache* cache, Real margin) {
  Manifold manifold;
  const bool swap = detail::comesSecond(a, A, b, B);
  const HullPair pair = swap ? detail::hullPair(b, B, a, A) : detail::hullPair(a, A, b, B);
  HullHint hint;
  const bool known = cache != nullptr && cache->axis >= 0;
  if (known) {
    hint = {static_cast<AxisKind>(cache->axis), cache->featureA, cache->featureB};
    if (swap) hint = swapped(hint);
  }
  const HullAxis best = detail::bestHullAxis(pair, known ? &hint : nullptr, margin);
  if (cache != nullptr) {
    HullHint next{best.kind, best.featureA, best.featureB};
    if (swap) next = swapped(next);
    cache->axis = static_cast<std::int32_t>(next.kind);
    cache->featureA = next.featureA;
    cache->featureB = next.featureB;
  }
  if (best.separation > margin) return manifold;
  fill(pair, swap ? B : A, best, margin, manifold);
  if (swap) detail::swapBodies(manifold);
  return manifold;
}

// Apart from the fast way, which would otherwise make room for a hull on every call.
[[gnu::noinline]] Manifold plainly(const Box& a, const Pose& A, const ConvexHull& b, const Pose& B,
                                   Real margin) {
  return plainManifold(boxHull(a.halfExtents), A, b, B, margin);
}

}  // namespace

Manifold collideHullsOn(const ConvexHull& hullA, const Pose& A, const ConvexHull& hullB,
                        const Pose& B, const ManifoldCache& features, Real margin) {
  const HullView a = detail::viewOf(hullA), b = detail::viewOf(hullB);
  Manifold manifold;
  if (features.axis < 0) return manifold;
  const bool swap = detail::comesSecond(a, A, b, B);
  const HullPair pair = swap ? detail::hullPair(b, B, a, A) : detail::hullPair(a, A, b, B);
  const HullHint known{static_cast<AxisKind>(features.axis), features.featureA, features.featureB};
  const std::optional<HullAxis> axis = detail::axisOfFeatures(pair, swap ? swapped(known) : known);
  if (!axis || axis->separation > margin) return manifold;
  fill(pair, swap ? B : A, *axis, margin, manifold);
  if (swap) detail::swapBodies(manifold);
  return manifold;
}

Manifold collideHulls(const ConvexHull& a, const Pose& A, const ConvexHull& b, const Pose& B,
                      ManifoldCache* cache, Real margin) {
  if (takesPlainPath()) return plainManifold(a, A, b, B, margin);
  return collideViews(detail::viewOf(a), A, detail::viewOf(b), B, cache, margin);
}

Manifold collideBoxAndHull(const Box& a, const Pose& A, const ConvexHull& b, const Pose& B,
                           ManifoldCache* cache, Real margin) {
  if (takesPlainPath()) return plainly(a, A, b, B, margin);
  const detail::BoxHullView box(a);
  return collideViews(box.view(), A, detail::viewOf(b), B, cache, margin);
}

}  // namespace carom
