// A list of axes with what they are made of; corners in world coordinates.
#include <limits>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/detection/sat_hulls.hpp"

namespace carom {

SeparatingAxis satHulls(const ConvexHull& a, const Pose& A, const ConvexHull& b, const Pose& B) {
  std::vector<SeparatingAxis> tries;
  const auto add = [&](const Vector3& axis, AxisKind kind, int i, int j) {
    SeparatingAxis t;
    t.axis = axis;
    t.kind = kind;
    t.featureA = i;
    t.featureB = j;
    tries.push_back(t);
  };
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    add(directionToWorld(A, a.faces[i].normal), AxisKind::faceOfA, static_cast<int>(i), -1);
  }
  for (std::size_t j = 0; j < b.faces.size(); ++j) {
    add(directionToWorld(B, b.faces[j].normal), AxisKind::faceOfB, -1, static_cast<int>(j));
  }
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    const Vector3 u = a.vertices[a.edges[i].to] - a.vertices[a.edges[i].from];
    for (std::size_t j = 0; j < b.edges.size(); ++j) {
      const Vector3 v = b.vertices[b.edges[j].to] - b.vertices[b.edges[j].from];
      const Vector3 w = cross(A.R_WB * u.normalized(), B.R_WB * v.normalized());
      if (w.norm() > 1e-12) {
        add(w.normalized(), AxisKind::edges, static_cast<int>(i), static_cast<int>(j));
      }
    }
  }
  SeparatingAxis best;
  best.separation = -std::numeric_limits<Real>::infinity();
  for (SeparatingAxis& t : tries) {
    // The four ends, each corner relative to A.
    Real lowA = std::numeric_limits<Real>::infinity(), highA = -lowA;
    Real lowB = lowA, highB = highA;
    for (const Vector3& p : a.vertices) {
      const Real x = t.axis.dot(A.R_WB * p);
      lowA = std::min(lowA, x);
      highA = std::max(highA, x);
    }
    for (const Vector3& q : b.vertices) {
      const Real x = t.axis.dot(B.R_WB * q + (B.p_WB - A.p_WB));
      lowB = std::min(lowB, x);
      highB = std::max(highB, x);
    }
    const Real forwards = lowB - highA;
    const Real backwards = lowA - highB;
    t.separation = std::max(forwards, backwards);
    if (backwards > forwards) t.axis = -t.axis;
    t.verdict = verdictOf(t.separation);
    const Real tie = kAxisTie * (a.boundingRadius + b.boundingRadius);
    if (t.separation > best.separation + (t.kind == AxisKind::edges ? tie : 0)) best = t;
  }
  return best;
}

}  // namespace carom
