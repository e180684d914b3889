#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "bench/toi_peers.hpp"

namespace carom::bench {
namespace {

btTransform poseOf(const std::array<double, 7>& p) {
  return btTransform(btQuaternion(p[4], p[5], p[6], p[3]), btVector3(p[0], p[1], p[2]));
}

}  // namespace

PeerImpact hullsInBullet(const double* a, int countA, const PeerSweep& A, const double* b,
                         int countB, const PeerSweep& B) {
  btConvexHullShape hullA, hullB;
  for (int i = 0; i < countA; ++i)
    hullA.addPoint(btVector3(a[3 * i], a[3 * i + 1], a[3 * i + 2]), false);
  for (int i = 0; i < countB; ++i)
    hullB.addPoint(btVector3(b[3 * i], b[3 * i + 1], b[3 * i + 2]), false);
  hullA.setMargin(0);
  hullB.setMargin(0);
  hullA.recalcLocalAabb();
  hullB.recalcLocalAabb();
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btContinuousConvexCollision search(&hullA, &hullB, &simplex, &depth);
  btConvexCast::CastResult result;
  result.m_fraction = 1;
  PeerImpact found;
  found.hit = search.calcTimeOfImpact(poseOf(A.start), poseOf(A.end), poseOf(B.start),
                                      poseOf(B.end), result);
  found.time = result.m_fraction;
  return found;
}

}  // namespace carom::bench
