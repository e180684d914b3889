#include "carom/world/kept_manifold.hpp"

#include <cmath>
#include <cstddef>

namespace carom::world {

namespace {

Vector3 seenFrom(const Pose& pose, const Vector3& point) {
  return pose.R_WB.transpose() * (point - pose.p_WB);
}

}  // namespace

KeptManifold keptManifold(const Manifold& manifold, const Pose& A, const Pose& B, Real margin) {
  KeptManifold kept;
  kept.known = true;
  kept.margin = margin;
  kept.R.noalias() = A.R_WB.transpose() * B.R_WB;
  kept.t = seenFrom(A, B.p_WB);
  kept.normal = A.R_WB.transpose() * manifold.normal;
  if (manifold.count == 0) return kept;
  kept.centroid = seenFrom(A, manifold.areaCentroid);
  for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
    kept.onA[i] = seenFrom(A, pointOnA(manifold.normal, manifold.points[i]));
    kept.onB[i] = seenFrom(B, pointOnB(manifold.normal, manifold.points[i]));
  }
  return kept;
}

Real wayAgainst(const KeptManifold& kept, const Pose& A, const Pose& B, Real reach) {
  const Matrix3 R = A.R_WB.transpose() * B.R_WB;
  const Vector3 t = seenFrom(A, B.p_WB);
  // A point on the unit sphere moves by at most the chord of the angle turned, which is the norm of
  // what the matrix has changed by, divided by the root of two.
  const Real chord = (R - kept.R).norm() / std::sqrt(Real(2));
  return (t - kept.t).norm() + reach * chord;
}

void carryManifold(const KeptManifold& kept, const Pose& A, const Pose& B, Manifold& manifold) {
  manifold.normal = A.R_WB * kept.normal;
  manifold.areaCentroid = pointToWorld(A, kept.centroid);
  for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
    const Vector3 onA = pointToWorld(A, kept.onA[i]), onB = pointToWorld(B, kept.onB[i]);
    manifold.points[i].position = (onA + onB) / 2;
    manifold.points[i].separation = manifold.normal.dot(onB - onA);
  }
}

}  // namespace carom::world
