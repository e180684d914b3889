// Planar figures: their manifolds lie at z = 0 and are those of a slice of the spatial ones.

#include <cmath>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/detection/separate_polygons.hpp"
#include "carom/manifold/collide_planar.hpp"
#include "manifold_reference.hpp"

using namespace carom;
using namespace carom_test;

namespace {

Polygon rectangle(Real halfX, Real halfY) {
  const std::vector<Vector2> corners = {
      {-halfX, -halfY}, {halfX, -halfY}, {halfX, halfY}, {-halfX, halfY}};
  return makePolygon(corners);
}

// Corners on an ellipse, counter-clockwise.
Polygon randomPolygon(Random& random) {
  std::vector<Vector2> corners;
  const Real x = random.between(0.3, 1), y = random.between(0.3, 1);
  Real angle = random.between(0, 1);
  const Real end = angle + 6;
  while (angle < end) {
    corners.emplace_back(x * std::cos(angle), y * std::sin(angle));
    angle += random.between(0.4, 1.2);
  }
  return makePolygon(corners);
}

PlanarPose randomPlanarPose(Random& random, Real reach) {
  const Real angle = random.between(-3, 3);
  const Real x = random.between(-reach, reach), y = random.between(-reach, reach);
  return planarPoseOf(angle, {x, y});
}

std::vector<Vector2> placed(const Polygon& polygon, const PlanarPose& pose) {
  std::vector<Vector2> corners;
  for (const Vector2& corner : polygon.vertices) corners.push_back(pointToWorld(pose, corner));
  return corners;
}

}  // namespace

TEST_CASE("a square on a square: two points, the normal up, everything at z = 0") {
  const ConvexPlanarShape lower = rectangle(1, 0.5), upper = rectangle(0.4, 0.3);
  const PlanarPose A;
  PlanarPose B;
  B.p_WB = {0.8, 0.79};
  const Manifold manifold = collidePlanar(lower, A, upper, B);
  CHECK(manifold.normal == Vector3(0, 1, 0));
  REQUIRE(manifold.count == 2);
  Real left = 1e9, right = -1e9;
  for (int k = 0; k < 2; ++k) {
    const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(k)];
    CHECK(std::abs(point.separation + 0.01) <= 1e-15);
    CHECK(std::abs(point.position.y() - 0.495) <= 1e-15);
    CHECK(point.position.z() == 0);
    left = std::min(left, point.position.x());
    right = std::max(right, point.position.x());
  }
  CHECK(std::abs(left - 0.4) <= 1e-15);
  CHECK(std::abs(right - 1) <= 1e-15);
  CHECK((manifold.areaCentroid - Vector3(0.7, 0.495, 0)).norm() <= 1e-15);
  CHECK(manifold.area == 0);
}

TEST_CASE("random polygons: depth of the exact test, points on both, swapping mirrors") {
  Random random(51);
  Real worstDepth = 0, worstNormal = 0, outside = 0;
  int contacts = 0, wrongVerdict = 0, notMirrored = 0, sameNames = 0;
  for (int n = 0; n < 3000; ++n) {
    const Polygon a = randomPolygon(random), b = randomPolygon(random);
    const PlanarPose A = randomPlanarPose(random, 0.8), B = randomPlanarPose(random, 0.8);
    const SeparatingAxis axis = separatePolygons(placed(a, A), placed(b, B));
    const Manifold manifold = collidePlanar(a, A, b, B);
    wrongVerdict += (manifold.count > 0) != (axis.separation <= 0) ? 1 : 0;
    notMirrored += same(mirrored(collidePlanar(b, B, a, A)), manifold) ? 0 : 1;
    if (manifold.count == 0) continue;
    ++contacts;
    Real deepest = 0;
    for (int k = 0; k < manifold.count; ++k) {
      const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(k)];
      deepest = std::min(deepest, point.separation);
      const Vector2 onA = pointOnA(manifold.normal, point).head<2>();
      const Vector2 onB = pointOnB(manifold.normal, point).head<2>();
      outside = std::max(outside, std::abs(closestPoint(PlanarShape(a), A, onA).distance));
      outside = std::max(outside, std::abs(closestPoint(PlanarShape(b), B, onB).distance));
    }
    worstDepth = std::max(worstDepth, std::abs(deepest - axis.separation));
    worstNormal = std::max(worstNormal, (manifold.normal - axis.axis).norm());
    sameNames += namesDiffer(manifold) ? 0 : 1;
  }
  CHECK(contacts > 1000);
  CHECK(wrongVerdict == 0);
  CHECK(notMirrored == 0);
  CHECK(sameNames == 0);
  CHECK(worstDepth <= 1e-14);
  CHECK(worstNormal <= 1e-14);
  CHECK(outside <= 1e-14);
}

TEST_CASE("discs touch on the line of their centres, and polygons at their nearest point") {
  const ConvexPlanarShape disc = Disc{0.5}, square = rectangle(1, 1);
  PlanarPose B;
  B.p_WB = {0.6, 0.7};
  const Manifold discs = collidePlanar(disc, PlanarPose(), disc, B);
  REQUIRE(discs.count == 1);
  CHECK(std::abs(discs.points[0].separation - (std::sqrt(0.85) - 1)) <= 1e-15);
  CHECK((discs.normal - Vector3(0.6, 0.7, 0) / std::sqrt(0.85)).norm() <= 1e-15);
  B.p_WB = {1.3, 0.2};
  const Manifold mixed = collidePlanar(square, PlanarPose(), disc, B);
  REQUIRE(mixed.count == 1);
  CHECK(mixed.normal == Vector3(1, 0, 0));
  CHECK(std::abs(mixed.points[0].separation + 0.2) <= 1e-15);
  CHECK((mixed.points[0].position - Vector3(0.9, 0.2, 0)).norm() <= 1e-15);
  CHECK(same(mirrored(collidePlanar(disc, B, square, PlanarPose())), mixed));
}

TEST_CASE("planar compounds touch part by part") {
  const PlanarShape pair = makePlanarCompound(
      {{Disc{0.5}, PlanarPose()}, {rectangle(0.5, 0.5), planarPoseOf(0, {2, 0})}});
  const PlanarShape floor = rectangle(10, 1);
  std::vector<PartManifold> manifolds;
  collidePlanar(floor, planarPoseOf(0, {0, -1.49}), pair, PlanarPose(), manifolds);
  REQUIRE(manifolds.size() == 2);
  CHECK(manifolds[0].manifold.count == 1);
  CHECK(manifolds[1].manifold.count == 2);
  CHECK(manifolds[1].partB == 1);
  for (const PartManifold& part : manifolds) CHECK(part.manifold.normal == Vector3(0, 1, 0));
  CHECK_THROWS_AS(collidePlanar(floor, PlanarPose(), pair, PlanarPose(), manifolds, -1),
                  InvalidInput);
}
