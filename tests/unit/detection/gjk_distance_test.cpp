// Support points, the nearest point of a simplex, and GJK in its plain form.

#include <cmath>
#include <limits>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/detection/convex_hull.hpp"
#include "carom/detection/gjk_distance.hpp"
#include "carom/detection/simplex.hpp"
#include "carom/detection/support_point.hpp"
#include "detection_reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

constexpr Real kUlp = 2.220446049250313e-16;

std::vector<Vector3> placed(std::vector<Vector3> points, const Pose& pose) {
  for (Vector3& point : points) point = pointToWorld(pose, point);
  return points;
}

Simplex<3> simplexOf(const std::vector<Vector3>& points) {
  Simplex<3> simplex;
  for (const Vector3& p : points) {
    simplex.vertices[static_cast<std::size_t>(simplex.count++)] = {p, p, Vector3::Zero(), -1, -1};
  }
  return simplex;
}

}  // namespace

TEST_CASE("the support point is the farthest, and the first of equals") {
  const std::vector<Vector3> box = boxHull({1, 2, 3}).vertices;
  CHECK(box[supportPoint(box, {1, -1, 0.5})] == Vector3(1, -2, 3));
  CHECK(supportPoint(box, {0, 0, 0}) == 0);
  CHECK(supportPoint(box, {1, 0, 0}) == 1);
  CHECK_THROWS_AS(supportPoint({}, {1, 0, 0}), InvalidInput);
}

TEST_CASE("D15: GJK finds the nearest points of segments, skew and parallel, and of a triangle") {
  const json expected = detectionCase("D15");
  const auto corners = [](const json& list) {
    std::vector<Vector3> points;
    for (const json& point : list) points.push_back(readVector(point));
    return points;
  };
  const PointDistance skew =
      gjkDistance(corners(expected["a"]["first"]), corners(expected["a"]["second"]));
  CHECK_THAT(skew.distance, WithinRel(std::sqrt(readNumber(expected["a"]["squared"])), 4e-16));
  CHECK((skew.pointA - readVector(expected["a"]["points"][0])).norm() <= 4 * kUlp);
  CHECK((skew.pointB - readVector(expected["a"]["points"][1])).norm() <= 4 * kUlp);

  const PointDistance parallel =
      gjkDistance(corners(expected["b"]["first"]), corners(expected["b"]["second"]));
  CHECK_THAT(parallel.distance, WithinRel(std::sqrt(6.0), 4e-16));
  CHECK_THAT((parallel.pointA - parallel.pointB).norm(), WithinRel(std::sqrt(6.0), 1e-15));
  CHECK(std::abs((parallel.pointA - parallel.pointB).dot(Vector3(2, 1, 0))) <= 8 * kUlp);

  const std::vector<Vector3> point = {readVector(expected["c"]["point"])};
  const PointDistance triangle = gjkDistance(point, corners(expected["c"]["triangle"]));
  CHECK_THAT(triangle.distance, WithinRel(std::sqrt(2.5), 4e-16));
  CHECK((triangle.pointB - readVector(expected["c"]["nearest"])).norm() <= 4 * kUlp);
}

TEST_CASE("GJK measures the gap between boxes: face to face, edge to edge, corner to corner") {
  const std::vector<Vector3> box = boxHull({1, 1, 1}).vertices;
  const auto distance = [&](const Vector3& offset) {
    return gjkDistance(box, placed(box, {Matrix3::Identity(), offset})).distance;
  };
  CHECK(distance({3, 0.25, -0.5}) == 1);
  CHECK(distance({3, 4, 0.5}) == std::sqrt(5.0));
  CHECK_THAT(distance({3, -4, 5}), WithinRel(std::sqrt(14.0), 2 * kUlp));
}

TEST_CASE("GJK ends on bodies that touch: faces, edges and corners, and one inside the other") {
  const std::vector<Vector3> box = boxHull({1, 1, 1}).vertices;
  CaseNumbers random(77);
  for (int i = 0; i < 2000; ++i) {
    // Offsets 0, 1/2, 1 or 2 along each axis: shared faces, edges, corners, and overlaps.
    Vector3 offset;
    for (int k = 0; k < 3; ++k) offset(k) = 0.5 * static_cast<Real>(random.next() % 5);
    const Pose common = i % 2 == 0 ? Pose{} : random.pose(5);
    const auto a = placed(box, common);
    const auto b = placed(box, composed(common, {Matrix3::Identity(), offset}));
    const PointDistance result = gjkDistance(a, b);
    REQUIRE(result.distance <= 16 * kUlp);
    REQUIRE(result.iterations <= 30);
    // A common point inside a flat simplex is known to half the digits only.
    REQUIRE((result.pointA - result.pointB).norm() <= 1e-7);
  }
}

TEST_CASE("GJK agrees with the distance by all pairs of triangles' features") {
  // Oracle: the distance of two segments and of a point and a triangle, over all of them.
  CaseNumbers random(4711);
  for (int i = 0; i < 500; ++i) {
    std::vector<Vector3> a, b;
    for (int k = 0; k < 4; ++k) a.push_back(random.vectorBetween(-1, 1));
    for (int k = 0; k < 4; ++k) b.push_back(random.vectorBetween(-1, 1) + Vector3(1.5, 0, 0));
    const PointDistance result = gjkDistance(a, b);
    if (result.distance == 0) continue;
    // The answer's own proof: the plane through pointA, square to the gap, has A on one side, and
    // the one through pointB has B on the other. Nothing nearer can exist then.
    const Vector3 gap = result.pointB - result.pointA;
    Real reach = 0;
    for (const Vector3& p : a) reach = std::max(reach, gap.dot(p - result.pointA));
    for (const Vector3& q : b) reach = std::max(reach, gap.dot(result.pointB - q));
    CHECK(reach <= 64 * kUlp);
    CHECK(std::abs(gap.norm() - result.distance) <= 16 * kUlp);
  }
}

TEST_CASE("GJK refuses what is not a body") {
  const std::vector<Vector3> one = {{0, 0, 0}};
  const std::vector<Vector3> bad = {{0, std::numeric_limits<Real>::infinity(), 0}};
  CHECK_THROWS_AS(gjkDistance({}, one), InvalidInput);
  CHECK_THROWS_AS(gjkDistance(one, bad), InvalidInput);
}

TEST_CASE("the nearest point of a simplex is nearer than any other of its points") {
  CaseNumbers random(12);
  for (int i = 0; i < 3000; ++i) {
    std::vector<Vector3> points;
    const int count = 1 + static_cast<int>(random.next() % 4);
    for (int k = 0; k < count; ++k) {
      Vector3 p = random.vectorBetween(-1, 1) + Vector3(0.3, 0.2, 0.1);
      if (i % 3 == 0) p.z() = 0.25;                                                     // flat
      if (i % 5 == 0 && k > 0) p = points[0] + (p - points[0]).x() * Vector3(1, 2, 3);  // in a line
      points.push_back(p);
    }
    Simplex<3> simplex = simplexOf(points);
    const Vector3 nearest = closestToOrigin(simplex);
    Real sum = 0;
    Vector3 mixed = Vector3::Zero(), other = Vector3::Zero();
    for (std::size_t k = 0; k < static_cast<std::size_t>(simplex.count); ++k) {
      REQUIRE(simplex.weights[k] >= 0);
      sum += simplex.weights[k];
      mixed += simplex.weights[k] * simplex.vertices[k].difference;
    }
    witnessPoints(simplex, mixed, other);
    REQUIRE(std::abs(sum - 1) <= 8 * kUlp);
    if (simplex.count < 4) REQUIRE((mixed - nearest).norm() <= 1e-14);
    // No corner lies nearer to the origin, measured along the answer (a supporting plane).
    for (const Vector3& p : points) REQUIRE(nearest.dot(p) >= nearest.squaredNorm() - 1e-14);
  }
}

TEST_CASE("in the plane the nearest point of a triangle is found, or the origin is inside") {
  CaseNumbers random(13);
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    Simplex<2> simplex;
    std::vector<Vector2> points;
    for (int k = 0; k < 3; ++k) {
      points.emplace_back(random.between(-1, 1.5), random.between(-1, 1.5));
      simplex.vertices[static_cast<std::size_t>(simplex.count++)].difference = points.back();
    }
    const Vector2 nearest = closestToOrigin(simplex);
    inside += simplex.count == 3;
    for (const Vector2& p : points) REQUIRE(nearest.dot(p) >= nearest.squaredNorm() - 1e-14);
  }
  CHECK(inside > 300);
  CHECK(inside < 2000);
}

TEST_CASE("a short edge far from the origin has weights that add to one") {
  CaseNumbers random(14);
  for (int i = 0; i < 1000; ++i) {
    const Vector3 middle = 4 * random.direction();
    const Vector3 along = std::pow(10.0, random.between(-14, -3)) * random.direction();
    Simplex<3> simplex = simplexOf({middle - along, middle + random.between(0, 1) * along});
    closestToOrigin(simplex);
    Real sum = 0;
    for (int k = 0; k < simplex.count; ++k) sum += simplex.weights[static_cast<std::size_t>(k)];
    REQUIRE(std::abs(sum - 1) <= 2 * kUlp);
    Vector3 onA, onB;
    witnessPoints(simplex, onA, onB);
    REQUIRE((onA - middle).norm() <= along.norm() + 16 * kUlp);
  }
}
