// Manifolds that are carried along are as good as they promise.

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/random.hpp"
#include "carom/detection/hull_axes.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/separate_hulls.hpp"
#include "carom/manifold/collide_hulls.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom/world/kept_manifold.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"

using namespace carom_test;
using carom::Manifold;
using carom::Pose;
using carom::world::KeptManifold;

namespace {

ConvexHull someHull(Random& random) {
  std::vector<Vector3> corners;
  for (int i = 0; i < 20; ++i) corners.push_back(0.3 * random.direction());
  return hullOfPoints(corners);
}

Pose movedBy(const Pose& pose, const Vector3& way, const Vector3& turn) {
  const Quaternion turned = integrateOrientation(Quaternion{}, turn, 1);
  return {quaternionToMatrix(turned) * pose.R_WB, pose.p_WB + way};
}

// How far the corners of a hull have moved against another body.
Real farthest(const ConvexHull& hull, const Pose& A, const Pose& B, const Pose& C, const Pose& D) {
  Real most = 0;
  for (const Vector3& corner : hull.vertices) {
    const Vector3 before = A.R_WB.transpose() * (pointToWorld(B, corner) - A.p_WB);
    const Vector3 after = C.R_WB.transpose() * (pointToWorld(D, corner) - C.p_WB);
    most = std::max(most, (after - before).norm());
  }
  return most;
}

Real deepest(const Manifold& manifold) {
  Real least = manifold.points[0].separation;
  for (int i = 1; i < manifold.count; ++i) {
    least = std::min(least, manifold.points[static_cast<std::size_t>(i)].separation);
  }
  return least;
}

}  // namespace

TEST_CASE("a manifold that is carried is off by no more than twice the way") {
  constexpr Real kMargin = 0.02, kReach = 0.3;
  Random random(2027);
  int carried = 0;
  for (int n = 0; n < 3000; ++n) {
    const ConvexHull a = someHull(random), b = someHull(random);
    const Vector3 place = random.vector(1);
    const Pose A = movedBy(Pose(), place, random.vector(3));
    // Anywhere from an overlap of a few centimetres to just apart.
    const Real distance = random.between(0.45, 0.58);
    const Vector3 apart = distance * random.direction();
    const Pose B = movedBy(A, apart, random.vector(3));
    const Manifold made = collideHulls(a, A, b, B, nullptr, kMargin);
    if (made.count == 0) continue;
    const KeptManifold kept = carom::world::keptManifold(made, A, B, kMargin);
    // The two go somewhere together, and against each other by a little.
    const Vector3 way = random.vector(2);
    const Vector3 turn = random.vector(0.4);
    const Real little = n % 2 == 0 ? 1e-4 : 1e-3;
    const Pose C = movedBy(A, way, turn);
    Pose D = movedBy({B.R_WB, B.p_WB - A.p_WB}, Vector3::Zero(), turn);
    D.p_WB = C.p_WB +
             quaternionToMatrix(integrateOrientation(Quaternion{}, turn, 1)) * (B.p_WB - A.p_WB);
    const Vector3 shift = little / 2 * random.direction();
    const Vector3 twist = little * random.direction();
    D = movedBy(D, shift, twist);
    const Real against = carom::world::wayAgainst(kept, C, D, kReach);
    CHECK(against >= farthest(b, A, B, C, D) - 1e-15);
    CHECK(against < little);
    Manifold now = made;
    carom::world::carryManifold(kept, C, D, now);
    const Manifold anew = collideHulls(a, C, b, D, nullptr, kMargin);
    INFO("case " << n);
    REQUIRE((anew.count > 0 || deepest(now) > kMargin - 2 * against));
    if (anew.count == 0) continue;
    CHECK(std::abs(deepest(now) - deepest(anew)) <= 2 * against);
    ++carried;
  }
  CHECK(carried > 1000);
}

TEST_CASE("features that were the nearest ones miss no more than the way since then") {
  constexpr Real kMargin = 0.02, kRounding = 1e-14;
  Random random(2029);
  int faces = 0, edges = 0, gone = 0;
  for (int n = 0; n < 3000; ++n) {
    const ConvexHull a = someHull(random), b = someHull(random);
    const Vector3 place = random.vector(1);
    const Pose A = movedBy(Pose(), place, random.vector(3));
    const Real distance = random.between(0.45, 0.58);
    const Vector3 apart = distance * random.direction();
    const Pose B = movedBy(A, apart, random.vector(3));
    carom::ManifoldCache features;
    const Manifold made = collideHulls(a, A, b, B, &features, kMargin);
    if (made.count == 0) continue;
    INFO("case " << n);
    const Manifold same = collideHullsOn(a, A, b, B, features, kMargin);
    REQUIRE(same.count == made.count);
    CHECK(same.normal == made.normal);
    CHECK(deepest(same) == deepest(made));
    // B moves against A. Any axis shows less of a gap than the best one, and what was the best one
    // cannot have fallen far behind.
    const Real little = n % 2 == 0 ? 1e-3 : 1e-2;
    const Vector3 shift = little / 2 * random.direction();
    const Pose D = movedBy(B, shift, little * random.direction());
    const Real against = farthest(b, A, B, A, D);
    const detail::HullPair pair = detail::hullPair(detail::viewOf(a), A, detail::viewOf(b), D);
    const bool swap = detail::comesSecond(detail::viewOf(a), A, detail::viewOf(b), D);
    if (swap) continue;  // the features are named the other way round
    const detail::HullHint hint{static_cast<AxisKind>(features.axis), features.featureA,
                                features.featureB};
    const detail::HullAxis best =
        detail::bestHullAxis(pair, nullptr, std::numeric_limits<Real>::infinity());
    const std::optional<detail::HullAxis> kept = detail::axisOfFeatures(pair, hint);
    const Manifold now = collideHullsOn(a, A, b, D, features, kMargin);
    if (!kept) {
      CHECK(hint.kind == AxisKind::edges);
      CHECK(now.count == 0);
      ++gone;
      continue;
    }
    CHECK(kept->separation <= best.separation + kRounding);
    if (hint.kind == AxisKind::edges) {
      ++edges;
      continue;
    }
    CHECK(kept->separation >= best.separation - 2 * against - kRounding);
    ++faces;
  }
  CHECK(faces > 300);
  CHECK(edges > 100);
  CHECK(gone > 0);
}

TEST_CASE("a manifold that is carried nowhere is the same") {
  Random random(2028);
  const ConvexHull a = someHull(random), b = someHull(random);
  const Pose A = movedBy(Pose(), Vector3(1, 2, 3), Vector3(0.3, 0.2, 0.1));
  const Pose B = movedBy(A, Vector3(0.1, 0.2, 0.45), Vector3(0, 1, 0));
  const Manifold made = collideHulls(a, A, b, B, nullptr, 0.02);
  REQUIRE(made.count > 0);
  const KeptManifold kept = carom::world::keptManifold(made, A, B, 0.02);
  Manifold now = made;
  carom::world::carryManifold(kept, A, B, now);
  // A few roundings of coordinates of some metres.
  constexpr Real kRounding = 1e-14;
  for (int i = 0; i < made.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    CHECK((now.points[k].position - made.points[k].position).norm() < kRounding);
    CHECK(std::abs(now.points[k].separation - made.points[k].separation) < kRounding);
  }
}
