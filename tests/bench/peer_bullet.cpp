#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>

#include "bench/narrowphase_peers.hpp"

namespace carom::bench {
namespace {

btVector3 toBullet(const Vector3& v) {
  return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

btTransform toBullet(const Pose& pose) {
  btMatrix3x3 basis;
  for (int i = 0; i < 3; ++i) {
    basis[i] =
        btVector3(btScalar(pose.R_WB(i, 0)), btScalar(pose.R_WB(i, 1)), btScalar(pose.R_WB(i, 2)));
  }
  return btTransform(basis, toBullet(pose.p_WB));
}

Vector3 fromBullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

// Keeps the deepest point and counts all.
struct Collector : btDiscreteCollisionDetectorInterface::Result {
  PairAnswer answer;
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normalOnB, const btVector3&, btScalar depth) override {
    if (answer.points == 0 || depth < answer.separation) {
      answer.separation = depth;
      answer.normal = -fromBullet(normalOnB);
    }
    answer.hit = answer.separation <= 0;
    ++answer.points;
  }
};

struct Transforms {
  std::vector<btTransform> A, B;
  explicit Transforms(std::span<const BodyPair> pairs) {
    for (const BodyPair& pair : pairs) {
      A.push_back(toBullet(pair.A));
      B.push_back(toBullet(pair.B));
    }
  }
};

PairAnswer gjkEpa(const btConvexShape& a, const btTransform& A, const btConvexShape& b,
                  const btTransform& B) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver penetration;
  btGjkPairDetector detector(&a, &b, &simplex, &penetration);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = A;
  input.m_transformB = B;
  Collector result;
  detector.getClosestPoints(input, result, nullptr);
  return result.answer;
}

}  // namespace

std::vector<PairMethod> bulletBoxes(std::span<const BodyPair> pairs) {
  struct Data {
    Transforms at;
    std::vector<btBoxShape> a, b;
  };
  const auto data = std::make_shared<Data>(Data{Transforms(pairs), {}, {}});
  for (const BodyPair& pair : pairs) {
    data->a.emplace_back(toBullet(pair.halfA));
    data->b.emplace_back(toBullet(pair.halfB));
    // To GJK its boxes have corners rounded by 4 cm unless told otherwise.
    data->a.back().setMargin(0);
    data->b.back().setMargin(0);
  }
  return {{"Bullet btBoxBoxDetector",
           [data](std::size_t i) {
             btBoxBoxDetector detector(&data->a[i], &data->b[i]);
             btBoxBoxDetector::ClosestPointInput input;
             input.m_transformA = data->at.A[i];
             input.m_transformB = data->at.B[i];
             Collector result;
             detector.getClosestPoints(input, result, nullptr);
             return result.answer;
           }},
          {"Bullet GJK+EPA", [data](std::size_t i) {
             return gjkEpa(data->a[i], data->at.A[i], data->b[i], data->at.B[i]);
           }}};
}

std::vector<PairMethod> bulletHulls(const ConvexHull& a, const ConvexHull& b,
                                    std::span<const BodyPair> pairs) {
  struct Data {
    Transforms at;
    btConvexHullShape a, b;
  };
  const auto data = std::make_shared<Data>(Data{Transforms(pairs), {}, {}});
  for (const Vector3& v : a.vertices) data->a.addPoint(toBullet(v));
  for (const Vector3& v : b.vertices) data->b.addPoint(toBullet(v));
  // Its hulls are a margin of 4 cm larger than their corners unless told otherwise.
  data->a.setMargin(0);
  data->b.setMargin(0);
  return {{"Bullet GJK+EPA", [data](std::size_t i) {
             return gjkEpa(data->a, data->at.A[i], data->b, data->at.B[i]);
           }}};
}

}  // namespace carom::bench
