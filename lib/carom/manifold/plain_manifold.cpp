#include "carom/manifold/plain_manifold.hpp"

#include <algorithm>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/detection/sat_hulls.hpp"
#include "carom/manifold/contact_ids.hpp"
#include "carom/manifold/edge_contact.hpp"
#include "carom/manifold/face_contact.hpp"
#include "carom/manifold/least_displacement.hpp"
#include "carom/manifold/orient_normal.hpp"
#include "carom/manifold/polygon_centroid.hpp"
#include "carom/manifold/reduce_contacts.hpp"

namespace carom {
namespace {

std::vector<Vector3> cornersOf(const ConvexHull& hull, const Pose& pose) {
  std::vector<Vector3> corners;
  for (const Vector3& vertex : hull.vertices) corners.push_back(pointToWorld(pose, vertex));
  return corners;
}

std::vector<Vector3> loopOf(const ConvexHull& hull, const HullFace& face,
                            const std::vector<Vector3>& corners) {
  std::vector<Vector3> loop;
  for (int k = 0; k < face.count; ++k) {
    loop.push_back(corners[hull.halfEdges[face.firstHalfEdge + k].origin]);
  }
  return loop;
}

// The face that looks most into a direction.
int faceTowards(const ConvexHull& hull, const Pose& pose, const Vector3& direction) {
  int best = 0;
  for (std::size_t f = 1; f < hull.faces.size(); ++f) {
    const Real along = directionToWorld(pose, hull.faces[f].normal).dot(direction);
    const Real most = directionToWorld(pose, hull.faces[best].normal).dot(direction);
    if (along > most + kAxisTie) best = static_cast<int>(f);
  }
  return best;
}

// Names the corners of a clipped face: a corner of the incident face keeps the name of that corner
// on the reference face. Plain clipping does not say which edges met in a new corner, so that one
// is called an edge by its place in the loop; collideHulls() knows better.
std::vector<std::uint32_t> namesOf(const std::vector<FacePoint>& points, bool referenceIsA,
                                   int referenceFace, const std::vector<Vector3>& incidentCorners) {
  std::vector<FeaturePair> pairs;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto same = std::find(incidentCorners.begin(), incidentCorners.end(), points[k].position);
    Feature reference{FeatureKind::face, static_cast<std::uint32_t>(referenceFace)};
    Feature incident{FeatureKind::vertex,
                     static_cast<std::uint32_t>(same - incidentCorners.begin())};
    if (same == incidentCorners.end()) {
      reference = {FeatureKind::edge, static_cast<std::uint32_t>(referenceFace)};
      incident = {FeatureKind::edge, static_cast<std::uint32_t>(k)};
    }
    if (referenceIsA) {
      pairs.push_back({reference, incident});
    } else {
      pairs.push_back({incident, reference});
    }
  }
  return contactIds(pairs);
}

}  // namespace

Manifold plainManifold(const ConvexHull& a, const Pose& A, const ConvexHull& b, const Pose& B,
                       Real margin) {
  Manifold manifold;
  const SeparatingAxis axis = satHulls(a, A, b, B);
  if (axis.separation > margin) return manifold;
  const std::vector<Vector3> cornersA = cornersOf(a, A), cornersB = cornersOf(b, B);
  const std::vector<Vector3> axes = {axis.axis};
  const LeastDisplacement least = leastDisplacement(axes, cornersA, cornersB);
  manifold.normal = orientNormal(least.normal, cornersA, cornersB);

  if (axis.kind == AxisKind::edges) {
    const HullEdge& edgeA = a.edges[axis.featureA];
    const HullEdge& edgeB = b.edges[axis.featureB];
    const EdgeContact contact =
        edgeContact(cornersA[edgeA.from], cornersA[edgeA.to], cornersB[edgeB.from],
                    cornersB[edgeB.to], manifold.normal);
    const std::vector<FeaturePair> pair = {
        {{FeatureKind::edge, static_cast<std::uint32_t>(axis.featureA)},
         {FeatureKind::edge, static_cast<std::uint32_t>(axis.featureB)}}};
    manifold.count = 1;
    manifold.points[0].position = (contact.pointA + contact.pointB) / 2;
    manifold.points[0].separation = contact.separation;
    manifold.points[0].id = contactIds(pair)[0];
    manifold.areaCentroid = manifold.points[0].position;
    return manifold;
  }

  // The opposite face, cut by the sides of the reference face.
  const bool ofA = axis.kind == AxisKind::faceOfA;
  const Vector3 out = ofA ? manifold.normal : Vector3(-manifold.normal);
  const int reference = ofA ? faceTowards(a, A, out) : faceTowards(b, B, out);
  const int incident = ofA ? faceTowards(b, B, -out) : faceTowards(a, A, -out);
  const std::vector<Vector3> referenceLoop =
      ofA ? loopOf(a, a.faces[reference], cornersA) : loopOf(b, b.faces[reference], cornersB);
  const std::vector<Vector3> incidentLoop =
      ofA ? loopOf(b, b.faces[incident], cornersB) : loopOf(a, a.faces[incident], cornersA);
  const Real tie = kAxisTie * (a.boundingRadius + b.boundingRadius);
  const std::vector<FacePoint> points =
      faceContact(referenceLoop, out, incidentLoop, std::max(margin, least.separation + tie));
  if (points.empty()) return manifold;
  const std::vector<std::uint32_t> ids = namesOf(points, ofA, reference, ofA ? cornersB : cornersA);

  // Halfway between the surfaces; then the four that hold it best.
  std::vector<Vector3> middles;
  std::vector<Real> separations;
  for (const FacePoint& point : points) {
    middles.push_back(point.position - point.separation / 2 * out);
    separations.push_back(point.separation);
  }
  const PolygonArea area = polygonCentroid(middles);
  manifold.area = area.area;
  manifold.areaCentroid = area.centroid;
  for (const int k : reduceContacts(middles, separations)) {
    ManifoldPoint& point = manifold.points[manifold.count++];
    point.position = middles[static_cast<std::size_t>(k)];
    point.separation = separations[static_cast<std::size_t>(k)];
    point.id = ids[static_cast<std::size_t>(k)];
  }
  return manifold;
}

}  // namespace carom
