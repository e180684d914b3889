// What each shape answers: support, bounds, closest point, containment, rays. Closed forms first,
// then what must hold for every shape in every pose.

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/detection/bounds.hpp"
#include "carom/detection/cast_ray.hpp"
#include "carom/detection/closest_point.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/support.hpp"
#include "detection_reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

constexpr Real kUlp = 2.220446049250313e-16;
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

ConvexHull cloud(int count, std::uint64_t seed) {
  CaseNumbers random(seed);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) points.push_back(random.direction());
  return hullOfPoints(points);
}

std::vector<ConvexShape> convexShapes() {
  return {Ball{0.7},    Box{{0.5, 1, 0.25}}, Capsule{0.4, 0.8},   Cylinder{0.6, 0.5},
          cloud(12, 1), cloud(300, 2),       boxHull({1, 2, 0.5})};
}

Shape toShape(const ConvexShape& convex) {
  return std::visit([](const auto& part) { return Shape(part); }, convex);
}

// All of the above, a compound and a half-space.
std::vector<Shape> allShapes() {
  std::vector<Shape> shapes;
  for (const ConvexShape& convex : convexShapes()) shapes.push_back(toShape(convex));
  shapes.push_back(makeHalfSpace({1, 2, 3}, {0.1, 0, 0}));
  CaseNumbers random(3);
  shapes.push_back(makeCompound({{Ball{0.5}, random.pose(0.5)},
                                 {Box{{0.2, 0.9, 0.3}}, random.pose(0.5)},
                                 {Cylinder{0.3, 0.7}, random.pose(0.5)}}));
  return shapes;
}

bool isHalfSpace(const Shape& shape) {
  return std::holds_alternative<HalfSpace>(shape);
}
bool isCompound(const Shape& shape) {
  return std::holds_alternative<Compound>(shape);
}

}  // namespace

TEST_CASE("support points in closed form") {
  CHECK(supportOf(Ball{2}, {0, 3, 4}).point == Vector3(0, 1.2, 1.6));
  CHECK(supportOf(Ball{2}, {0, 3e-200, 4e-200}).point == Vector3(0, 1.2, 1.6));
  CHECK(supportOf(Ball{2}, {0, 0, 0}).point == Vector3(0, 0, 2));
  CHECK(supportOf(Box{{1, 2, 3}}, {-1, 1, -1}).point == Vector3(-1, 2, -3));
  CHECK(supportOf(Box{{1, 2, 3}}, {-1, 1, -1}).id == 2);
  CHECK(supportOf(Capsule{1, 2}, {1, 0, 0}).point == Vector3(1, 0, 2));
  CHECK(supportOf(Capsule{1, 2}, {0, 0, -1}).point == Vector3(0, 0, -3));
  CHECK(supportOf(Cylinder{5, 1}, {3, 4, -1}).point == Vector3(3, 4, -1));
  CHECK(supportOf(Cylinder{5, 1}, {0, 0, 1}).point == Vector3(0, 0, 1));
  CHECK(supportOf(Disc{2}, {3, 4}).point == Vector2(1.2, 1.6));
  const Polygon square = makePolygon(std::vector<Vector2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK(supportOf(square, {1, 2}).id == 2);
}

TEST_CASE("a support point is on the shape, and nothing reaches farther") {
  CaseNumbers random(21);
  for (const ConvexShape& shape : convexShapes()) {
    for (int i = 0; i < 200; ++i) {
      const Vector3 d = random.direction();
      const Vector3 farthest = supportOf(shape, d).point;
      REQUIRE(std::abs(closestPoint(shape, Pose{}, farthest).distance) <= 4 * kUlp);
      for (int k = 0; k < 20; ++k) {
        const Vector3 other = supportOf(shape, random.direction()).point;
        REQUIRE(d.dot(other) <= d.dot(farthest) + 4 * kUlp);
      }
    }
  }
}

TEST_CASE("walking over a large hull finds the same corner as looking at all") {
  const ConvexHull hull = cloud(500, 4);
  REQUIRE(hull.vertices.size() == 500);
  CaseNumbers random(22);
  for (int i = 0; i < 1000; ++i) {
    const Vector3 d = random.direction();
    Real reach = -kInfinity;
    for (const Vector3& v : hull.vertices) reach = std::max(reach, d.dot(v));
    const auto start = static_cast<std::int32_t>(random.next() % 500);
    REQUIRE(d.dot(supportOf(hull, d, start).point) >= reach - 4 * kUlp);
  }
}

TEST_CASE("bounds are tight: they reach as far as the support points, no more and no less") {
  CaseNumbers random(23);
  for (const ConvexShape& shape : convexShapes()) {
    for (int i = 0; i < 50; ++i) {
      const Pose pose = random.pose(3);
      const Aabb<3> box = boundsOf(shape, pose);
      const Aabb<3> same = boundsOf(toShape(shape), pose);
      REQUIRE(box.low == same.low);
      for (int k = 0; k < 3; ++k) {
        const Vector3 axis = directionToBody(pose, Vector3::Unit(k));
        const Vector3 high = pointToWorld(pose, supportOf(shape, axis).point);
        const Vector3 low = pointToWorld(pose, supportOf(shape, -axis).point);
        REQUIRE(std::abs(box.high(k) - high(k)) <= 8 * kUlp);
        REQUIRE(std::abs(box.low(k) - low(k)) <= 8 * kUlp);
      }
    }
  }
}

TEST_CASE("bounds in closed form: a cube turned by 45 degrees, a floor, a compound") {
  const Pose turned =
      poseOf({std::cos(std::numbers::pi / 8), 0, 0, std::sin(std::numbers::pi / 8)}, {10, 0, 0});
  const Aabb<3> box = boundsOf(Shape(Box{{1, 1, 1}}), turned);
  CHECK_THAT(box.high.x(), WithinULP(10 + std::sqrt(2.0), 2));
  CHECK_THAT(box.low.y(), WithinULP(-std::sqrt(2.0), 4));
  CHECK(box.high.z() == 1);
  const Aabb<3> floor = boundsOf(makeHalfSpace({0, 0, 1}, {0, 0, 2}), Pose{});
  CHECK(floor.high == Vector3(kInfinity, kInfinity, 2));
  CHECK(floor.low.z() == -kInfinity);
  const Aabb<3> slope = boundsOf(makeHalfSpace({0, 1, 1}, {0, 0, 0}), Pose{});
  CHECK(slope.high.z() == kInfinity);
  const Aabb<3> two = boundsOf(makeCompound({{Ball{1}, {}}, {Ball{2}, poseOf({}, {5, 0, 0})}}),
                               poseOf({}, {0, 0, 1}));
  CHECK(two.low == Vector3(-1, -2, -1));
  CHECK(two.high == Vector3(7, 2, 3));
}

TEST_CASE("closest points in closed form") {
  const Pose here;
  const SurfacePoint corner = closestPoint(Shape(Box{{1, 2, 3}}), here, {4, 6, 3});
  CHECK(corner.distance == 5);
  CHECK(corner.point == Vector3(1, 2, 3));
  CHECK(corner.normal == Vector3(0.6, 0.8, 0));
  const SurfacePoint inside = closestPoint(Shape(Box{{1, 2, 3}}), here, {0.5, -1.75, 0});
  CHECK(inside.distance == -0.25);
  CHECK(inside.point == Vector3(0.5, -2, 0));
  CHECK(inside.normal == Vector3(0, -1, 0));
  const SurfacePoint capsule = closestPoint(Shape(Capsule{1, 2}), here, {0, 3, 6});
  CHECK(capsule.distance == 4);
  CHECK((capsule.point - Vector3(0, 0.6, 2.8)).norm() <= 4 * kUlp);
  CHECK(closestPoint(Shape(Capsule{1, 2}), here, {0, 0, 0}).distance == -1);
  const SurfacePoint rim = closestPoint(Shape(Cylinder{1, 1}), here, {4, 0, 5});
  CHECK(rim.distance == 5);
  CHECK(rim.point == Vector3(1, 0, 1));
  CHECK(closestPoint(Shape(Cylinder{1, 2}), here, {0.5, 0, 1.75}).distance == -0.25);
  CHECK(closestPoint(Shape(Cylinder{1, 2}), here, {0, 0.75, 0}).normal == Vector3(0, 1, 0));
  CHECK(closestPoint(Shape(Cylinder{1, 2}), here, {0, 0, 0}).distance == -1);
  const SurfacePoint floor = closestPoint(makeHalfSpace({0, 0, 1}, {0, 0, 1}), here, {3, 4, 7});
  CHECK(floor.distance == 6);
  CHECK(floor.point == Vector3(3, 4, 1));
  // The hull of a box answers as the box: over a face, an edge and a corner.
  for (const Vector3& p : {Vector3(2, 0.5, 0.5), Vector3(3, 4, 0.5), Vector3(3, 4, 7)}) {
    CHECK(closestPoint(Shape(boxHull({1, 2, 3})), here, p).distance ==
          closestPoint(Shape(Box{{1, 2, 3}}), here, p).distance);
  }
}

TEST_CASE("the closest point is on the surface, and no other is nearer") {
  CaseNumbers random(24);
  for (const Shape& shape : allShapes()) {
    const Pose pose = random.pose(2);
    int outside = 0, inside = 0;
    for (int i = 0; i < 300; ++i) {
      const Vector3 x = pointToWorld(pose, random.vectorBetween(-1.2, 1.2));
      const SurfacePoint found = closestPoint(shape, pose, x);
      (found.distance > 0 ? outside : inside) += 1;
      REQUIRE(std::abs(found.normal.norm() - 1) <= 4 * kUlp);
      REQUIRE((found.point + found.distance * found.normal - x).norm() <= 16 * kUlp);
      if (std::abs(found.distance) > 1e-14)
        REQUIRE(contains(shape, pose, x) == (found.distance < 0));
      if (found.distance > 0 || !isCompound(shape)) {
        REQUIRE(std::abs(closestPoint(shape, pose, found.point).distance) <= 16 * kUlp);
      }
      for (int k = 0; k < 20; ++k) {
        // Within the distance in any direction everything is on the same side of the surface.
        const Vector3 near = x + std::abs(found.distance) * 0.999999 * random.direction();
        REQUIRE(contains(shape, pose, near) == (found.distance < 0));
      }
    }
    CHECK(outside > 20);
    CHECK(inside > 5);
  }
}

TEST_CASE("a body contains its surface, to the last bit") {
  const Pose here;
  CHECK(contains(Shape(Ball{5}), here, {0, 3, 4}));
  CHECK_FALSE(contains(Shape(Ball{5}), here, {0, 3, std::nextafter(4.0, 5.0)}));
  CHECK(contains(Shape(Ball{0x1p-600}), here, {0, 0, 0x1p-600}));
  CHECK(contains(Shape(Box{{1, 2, 3}}), here, {1, -2, 3}));
  CHECK_FALSE(contains(Shape(Box{{1, 2, 3}}), here, {std::nextafter(1.0, 2.0), 0, 0}));
  CHECK(contains(Shape(Capsule{5, 1}), here, {3, 0, 5}));
  CHECK_FALSE(contains(Shape(Capsule{5, 1}), here, {3, 0, std::nextafter(5.0, 6.0)}));
  CHECK(contains(Shape(Cylinder{5, 1}), here, {3, 4, 1}));
  CHECK_FALSE(contains(Shape(Cylinder{5, 1}), here, {3, 4, std::nextafter(1.0, 2.0)}));
  CHECK(contains(Shape(boxHull({1, 2, 3})), here, {1, 2, 3}));
  CHECK(contains(makeHalfSpace({0, 0, 1}, {0, 0, 1}), here, {9, 9, 1}));
}

TEST_CASE("rays in closed form") {
  const Pose here;
  const RayHit ball = castRay(Shape(Ball{1}), here, {{-3, 0, 0}, {2, 0, 0}});
  REQUIRE(ball.hit);
  CHECK(ball.t == 1);
  CHECK(ball.point == Vector3(-1, 0, 0));
  CHECK(ball.normal == Vector3(-1, 0, 0));
  CHECK_FALSE(castRay(Shape(Ball{1}), here, {{-3, 0, 0}, {1, 0, 0}, 1.99}).hit);
  CHECK_FALSE(castRay(Shape(Ball{1}), here, {{-3, 0, 0}, {-1, 0, 0}}).hit);
  CHECK(castRay(Shape(Ball{1}), here, {{-3, 1, 0}, {1, 0, 0}}).hit);  // grazing
  const RayHit box = castRay(Shape(Box{{1, 2, 3}}), here, {{0, 0, 10}, {0.1, 0, -1}});
  REQUIRE(box.hit);
  CHECK(box.t == 7);
  CHECK(box.normal == Vector3(0, 0, 1));
  const RayHit cap = castRay(Shape(Capsule{1, 2}), here, {{0, 0, 9}, {0, 0, -1}});
  CHECK(cap.t == 6);
  CHECK(castRay(Shape(Capsule{1, 2}), here, {{5, 0, 1}, {-1, 0, 0}}).t == 4);
  CHECK(castRay(Shape(Cylinder{1, 2}), here, {{0.5, 0, 9}, {0, 0, -1}}).t == 7);
  CHECK(castRay(Shape(Cylinder{1, 2}), here, {{0, 5, 1}, {0, -2, 0}}).t == 2);
  CHECK_FALSE(castRay(Shape(Cylinder{1, 2}), here, {{0, 5, 2.5}, {0, -1, 0}}).hit);
  CHECK(castRay(makeHalfSpace({0, 0, 1}, {0, 0, 1}), here, {{0, 0, 3}, {1, 0, -1}}).t == 2);
  const RayHit inside = castRay(Shape(Box{{1, 1, 1}}), here, {{0, 0, 0}, {1, 0, 0}});
  CHECK(inside.hit);
  CHECK(inside.startsInside);
  CHECK(inside.t == 0);
}

TEST_CASE("a ball seen from a million radii away is hit where it is") {
  const RayHit hit = castRay(Shape(Ball{1}), Pose{}, {{-1e6, 0.6, 0}, {1, 0, 0}});
  REQUIRE(hit.hit);
  CHECK(std::abs(hit.point.x() - -0.8) <= 2e-10);  // an ulp of a million
}

TEST_CASE("a ray meets a body where marching along it meets it") {
  CaseNumbers random(25);
  for (const Shape& shape : allShapes()) {
    int hits = 0;
    for (int i = 0; i < 150; ++i) {
      const Pose pose = random.pose(1);
      const Ray ray{pointToWorld(pose, 3 * random.direction()), random.direction(), 6};
      const Ray aimed{ray.origin, pointToWorld(pose, random.vectorBetween(-1, 1)) - ray.origin, 2};
      const Ray& cast = i % 3 == 0 ? ray : aimed;
      const RayHit hit = castRay(shape, pose, cast);
      // The oracle: the distance to the surface is a safe step.
      Real t = 0;
      const Real whole = cast.direction.norm();
      for (int step = 0; step < 4000 && t <= cast.reach; ++step) {
        const Real distance = closestPoint(shape, pose, cast.origin + t * cast.direction).distance;
        if (distance <= 1e-13) break;
        t += distance / whole;
      }
      if (hit.hit) {
        ++hits;
        REQUIRE(std::abs(closestPoint(shape, pose, hit.point).distance) <=
                (hit.startsInside ? 9 : 64 * kUlp));
        REQUIRE((hit.startsInside || hit.normal.dot(cast.direction) <= 1e-12));
        // Near grazing the march creeps; what it has left is measured along the ray.
        REQUIRE(t <= hit.t + 1e-12);
        REQUIRE(std::abs(t - hit.t) <= 1e-5);
      } else {
        REQUIRE(t > cast.reach - 1e-5);
      }
    }
    CHECK((hits > 20 || isHalfSpace(shape)));
  }
}

TEST_CASE("a ray that cannot be cast is refused") {
  const Shape ball = Ball{1};
  CHECK_THROWS_AS(castRay(ball, Pose{}, {{0, 0, 0}, {0, 0, 0}}), InvalidInput);
  CHECK_THROWS_AS(castRay(ball, Pose{}, {{0, 0, 0}, {1, 0, 0}, -1}), InvalidInput);
  CHECK_THROWS_AS(castRay(ball, Pose{}, {{0, kInfinity, 0}, {1, 0, 0}}), InvalidInput);
}

TEST_CASE("planar figures answer as their prisms and balls do") {
  const Polygon triangle = makePolygon(std::vector<Vector2>{{-1, -1}, {2, 0}, {0, 1}});
  const PlanarShape figures[] = {Disc{0.7}, triangle,
                                 makePlanarCompound({{Disc{0.5}, planarPoseOf(0, {1, 0})},
                                                     {triangle, planarPoseOf(1, {-1, 0})}})};
  CaseNumbers random(26);
  for (const PlanarShape& figure : figures) {
    for (int i = 0; i < 300; ++i) {
      const PlanarPose pose = planarPoseOf(random.between(-3, 3), {random.between(-2, 2), 0.5});
      const Vector2 x(random.between(-3, 3), random.between(-3, 3));
      const OutlinePoint found = closestPoint(figure, pose, x);
      REQUIRE((found.point + found.distance * found.normal - x).norm() <= 16 * kUlp);
      REQUIRE(contains(figure, pose, x) == (found.distance <= 0));
      for (int k = 0; k < 10; ++k) {
        const Real angle = random.between(-4, 4);
        const Vector2 near =
            x + std::abs(found.distance) * 0.999999 * Vector2(std::cos(angle), std::sin(angle));
        REQUIRE(contains(figure, pose, near) == (found.distance < 0));
      }
      const Aabb<2> box = boundsOf(figure, pose);
      REQUIRE((found.distance > 0 || meets(box, Aabb<2>{x, x})));
      const PlanarRay ray{x, {std::cos(0.1 * i), std::sin(0.1 * i)}, 10};
      const PlanarRayHit hit = castRay(figure, pose, ray);
      if (hit.hit && !hit.startsInside) {
        REQUIRE(std::abs(closestPoint(figure, pose, hit.point).distance) <= 64 * kUlp);
        REQUIRE(std::abs(hit.normal.norm() - 1) <= 8 * kUlp);
        REQUIRE_FALSE(contains(figure, pose, ray.origin + 0.999 * hit.t * ray.direction));
      }
      REQUIRE((hit.startsInside == (hit.hit && found.distance <= 0)));
    }
  }
  const PlanarRayHit disc = castRay(PlanarShape(Disc{1}), PlanarPose{}, {{-3, 0}, {1, 0}});
  CHECK(disc.t == 2);
  CHECK(disc.normal == Vector2(-1, 0));
}
