#include "carom/manifold/facing_feature.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/core/elementary.hpp"
#include "carom/detection/hull_axes.hpp"
#include "carom/detection/hull_view.hpp"
#include "carom/manifold/feature_name.hpp"

namespace carom::detail {
namespace {

void setPoint(const Vector3& point, std::uint32_t name, FacingFeature& feature) {
  feature.count = 1;
  feature.corners[0] = point;
  feature.cornerNames[0] = name;
}

void ofBall(const Ball& ball, const Vector3& place, const Vector3& direction,
            FacingFeature& feature) {
  setPoint(place + ball.radius * direction, nameOf(FeatureKind::surface, 0), feature);
}

// The body's z axis carries a capsule; its line faces directions that are nearly square to it.
void ofCapsule(const Capsule& capsule, const Matrix3& R, const Vector3& place,
               const Vector3& direction, FacingFeature& feature) {
  const Vector3 axis = R.col(2);
  const Real along = axis.dot(direction);
  const Vector3 half = capsule.halfLength * axis;
  if (std::abs(along) > kFacingSine) {
    const Real sign = along > 0 ? 1 : -1;
    setPoint(place + sign * half + capsule.radius * direction,
             nameOf(FeatureKind::vertex, along > 0 ? 1 : 0), feature);
    return;
  }
  // Square to the axis, so that the line lies on the surface.
  const Vector3 radial = (direction - along * axis).normalized();
  feature.count = 2;
  feature.corners[0] = place - half + capsule.radius * radial;
  feature.corners[1] = place + half + capsule.radius * radial;
  feature.cornerNames[0] = nameOf(FeatureKind::vertex, 0);
  feature.cornerNames[1] = nameOf(FeatureKind::vertex, 1);
  feature.edgeNames[0] = feature.edgeNames[1] = nameOf(FeatureKind::edge, 0);
}

// Corner k of a cap of radius one, the same bits on every machine.
const std::array<Vector2, kCapCorners>& capCorners() {
  static const std::array<Vector2, kCapCorners> corners = [] {
    std::array<Vector2, kCapCorners> made;
    constexpr Real kTurn = 6.283185307179586;
    for (int k = 0; k < kCapCorners; ++k) {
      const SineCosine angle = sineCosine(kTurn * k / kCapCorners);
      made[k] = {angle.cosine, angle.sine};
    }
    return made;
  }();
  return corners;
}

void ofCylinder(const Cylinder& cylinder, const Matrix3& R, const Vector3& place,
                const Vector3& direction, FacingFeature& feature) {
  const Vector3 axis = R.col(2);
  const Real along = axis.dot(direction);
  const Real sign = along > 0 ? 1 : -1;
  const Vector3 half = cylinder.halfHeight * axis;
  if (std::abs(along) >= kFacingCosine) {
    const int cap = along > 0 ? 1 : 0;
    feature.count = kCapCorners;
    feature.normal = sign * axis;
    feature.faceName = nameOf(FeatureKind::face, cap);
    for (int k = 0; k < kCapCorners; ++k) {
      // Counter-clockwise seen from outside: the lower cap runs backwards.
      const int i = cap == 1 ? k : kCapCorners - 1 - k;
      const Vector2& corner = capCorners()[i];
      feature.corners[k] = place + sign * half + (cylinder.radius * corner.x()) * R.col(0) +
                           (cylinder.radius * corner.y()) * R.col(1);
      feature.cornerNames[k] = nameOf(FeatureKind::vertex, kCapCorners * cap + i);
      feature.edgeNames[k] = nameOf(FeatureKind::edge, kCapCorners * cap + i);
    }
    return;
  }
  const Vector3 radial = (direction - along * axis).normalized();
  if (std::abs(along) > kFacingSine) {
    setPoint(place + sign * half + cylinder.radius * radial,
             nameOf(FeatureKind::edge, along > 0 ? 1 : 0), feature);
    return;
  }
  feature.count = 2;
  feature.corners[0] = place - half + cylinder.radius * radial;
  feature.corners[1] = place + half + cylinder.radius * radial;
  feature.cornerNames[0] = nameOf(FeatureKind::edge, 0);
  feature.cornerNames[1] = nameOf(FeatureKind::edge, 1);
  feature.edgeNames[0] = feature.edgeNames[1] = nameOf(FeatureKind::surface, 0);
}

// Of the edges that leave a vertex, the one that is most nearly square to a direction; -1 if none
// is within a few degrees of it.
int facingEdge(const HullView& hull, int vertex, const Vector3& direction_B) {
  int best = -1;
  Real least = kFacingSine;
  int side = hull.anyHalfEdge[vertex];
  do {
    const int e = hull.halfEdges[side].edge;
    const Vector3 along = hull.vertices[hull.edges[e].to] - hull.vertices[hull.edges[e].from];
    const Real sine = std::abs(along.dot(direction_B)) / along.norm();
    const bool tie = best >= 0 && std::abs(sine - least) <= kAxisTie;
    if (tie ? e < best : sine <= least) {
      best = e;
      least = sine;
    }
    side = hull.halfEdges[hull.halfEdges[side].twin].next;
  } while (side != hull.anyHalfEdge[vertex]);
  return best;
}

void ofPolyhedron(const HullView& hull, const Matrix3& R, const Vector3& place,
                  const Vector3& direction, FacingFeature& feature) {
  const Vector3 direction_B = R.transpose() * direction;
  // Of the faces around the farthest vertex the one that looks there most.
  const int vertex = farthestVertex(hull, direction_B);
  int best = -1;
  Real most = -2;
  int side = hull.anyHalfEdge[vertex];
  do {
    const int f = hull.halfEdges[side].face;
    const Real along = hull.faces[f].normal.dot(direction_B);
    const bool tie = best >= 0 && std::abs(along - most) <= kAxisTie;
    if (tie ? f < best : along > most) {
      best = f;
      most = along;
    }
    side = hull.halfEdges[hull.halfEdges[side].twin].next;
  } while (side != hull.anyHalfEdge[vertex]);
  if (most < kFacingCosine) {
    if (const int e = facingEdge(hull, vertex, direction_B); e >= 0) {
      const HullEdge& edge = hull.edges[e];
      feature.count = 2;
      feature.corners[0] = place + R * hull.vertices[edge.from];
      feature.corners[1] = place + R * hull.vertices[edge.to];
      feature.cornerNames[0] = nameOf(FeatureKind::vertex, edge.from);
      feature.cornerNames[1] = nameOf(FeatureKind::vertex, edge.to);
      feature.edgeNames[0] = feature.edgeNames[1] = nameOf(FeatureKind::edge, e);
      return;
    }
    setPoint(place + R * hull.vertices[vertex], nameOf(FeatureKind::vertex, vertex), feature);
    return;
  }
  const HullFace& face = hull.faces[best];
  feature.count = std::min(face.count, FacingFeature::kMost);
  feature.normal = R * face.normal;
  feature.faceName = nameOf(FeatureKind::face, best);
  for (int k = 0; k < feature.count; ++k) {
    const HullHalfEdge& edge = hull.halfEdges[face.firstHalfEdge + k];
    feature.corners[k] = place + R * hull.vertices[edge.origin];
    feature.cornerNames[k] = nameOf(FeatureKind::vertex, edge.origin);
    feature.edgeNames[k] = nameOf(FeatureKind::edge, edge.edge);
  }
}

}  // namespace

void facingFeature(const ShapeView& shape, const Matrix3& R, const Vector3& place,
                   const Vector3& direction, FacingFeature& feature) {
  if (const auto* ball = std::get_if<const Ball*>(&shape)) {
    ofBall(**ball, place, direction, feature);
  } else if (const auto* capsule = std::get_if<const Capsule*>(&shape)) {
    ofCapsule(**capsule, R, place, direction, feature);
  } else if (const auto* cylinder = std::get_if<const Cylinder*>(&shape)) {
    ofCylinder(**cylinder, R, place, direction, feature);
  } else if (const auto* box = std::get_if<const Box*>(&shape)) {
    const BoxHullView view(**box);
    ofPolyhedron(view.view(), R, place, direction, feature);
  } else {
    ofPolyhedron(viewOf(*std::get<const ConvexHull*>(shape)), R, place, direction, feature);
  }
}

}  // namespace carom::detail
