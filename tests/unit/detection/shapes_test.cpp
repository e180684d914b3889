// Poses and shapes: what they promise, and what their doors refuse.

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/detection/planar_shapes.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"
#include "support/catch.hpp"

using namespace carom;
using carom_test::ContainsSubstring;

namespace {

constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();
constexpr Real kUlp = 2.220446049250313e-16;

}  // namespace

TEST_CASE("a pose takes points to the world and back") {
  const Pose pose = poseOf({2, 1, -1, 0.5}, {3, -2, 7});
  const Vector3 x(0.3, -0.4, 1.5);
  CHECK((pointToBody(pose, pointToWorld(pose, x)) - x).norm() <= 8 * kUlp);
  CHECK((directionToBody(pose, directionToWorld(pose, x)) - x).norm() <= 8 * kUlp);
  CHECK(std::abs(directionToWorld(pose, x).norm() - x.norm()) <= 4 * kUlp);
}

TEST_CASE("a quarter turn about z takes x to y") {
  const Pose pose = poseOf({1, 0, 0, 1}, {10, 0, 0});
  CHECK((pointToWorld(pose, {1, 0, 0}) - Vector3(10, 1, 0)).norm() <= 2 * kUlp);
  const PlanarPose planar = planarPoseOf(std::numbers::pi / 2, {10, 0});
  CHECK((pointToWorld(planar, {1, 0}) - Vector2(10, 1)).norm() <= 2 * kUlp);
  CHECK((pointToBody(planar, {10, 1}) - Vector2(1, 0)).norm() <= 2 * kUlp);
}

TEST_CASE("a relative pose sees B as A sees it") {
  const Pose A = poseOf({2, 1, -1, 0.5}, {3, -2, 7});
  const Pose B = poseOf({1, -1, 4, 0.25}, {1, 1, 5});
  const Vector3 x(0.3, -0.4, 1.5);
  const Vector3 seen = pointToWorld(relativePose(A, B), x);
  CHECK((seen - pointToBody(A, pointToWorld(B, x))).norm() <= 32 * kUlp);
  const Pose back = composed(A, relativePose(A, B));
  CHECK((back.R_WB - B.R_WB).cwiseAbs().maxCoeff() <= 4 * kUlp);
  CHECK((back.p_WB - B.p_WB).norm() <= 32 * kUlp);
}

TEST_CASE("a relative pose far from the origin loses no digit of the gap") {
  for (const Real far : {0x1p10, 0x1p20, 0x1p30}) {
    const Pose A{Matrix3::Identity(), {far, 0, 0}};
    const Pose B{Matrix3::Identity(), {far + 2 + 0x1p-20, 0, 0}};
    CHECK(relativePose(A, B).p_WB.x() == 2 + 0x1p-20);
  }
}

TEST_CASE("planar poses compose as their angles add") {
  const PlanarPose A = planarPoseOf(0.7, {1, 2});
  const PlanarPose B = planarPoseOf(-1.9, {-3, 0.5});
  const PlanarPose sum = composed(A, B);
  CHECK(std::abs(sum.cosine - std::cos(-1.2)) <= 2 * kUlp);
  CHECK(std::abs(sum.sine - std::sin(-1.2)) <= 2 * kUlp);
  const PlanarPose back = relativePose(A, sum);
  CHECK(std::abs(back.cosine - B.cosine) <= 4 * kUlp);
  CHECK(std::abs(back.sine - B.sine) <= 4 * kUlp);
  CHECK((back.p_WB - B.p_WB).norm() <= 16 * kUlp);
}

TEST_CASE("bad poses are refused by name") {
  CHECK_THROWS_AS(poseOf({0, 0, 0, 0}, {0, 0, 0}), InvalidInput);
  CHECK_THROWS_AS(poseOf({1, 0, 0, 0}, {0, kNan, 0}), InvalidInput);
  CHECK_THROWS_AS(planarPoseOf(kNan, {0, 0}), InvalidInput);
  CHECK_THROWS_WITH(requireUsable(Pose{2 * Matrix3::Identity(), Vector3::Zero()}, "pose of A"),
                    ContainsSubstring("pose of A"));
  CHECK_THROWS_WITH(requireUsable(PlanarPose{1, 1, Vector2::Zero()}, "pose of B"),
                    ContainsSubstring("pose of B"));
  CHECK_NOTHROW(requireUsable(poseOf({1, 2, 3, 4}, {1, 2, 3}), "pose"));
}

TEST_CASE("lengths that are not positive are refused, with the value in the message") {
  CHECK_THROWS_WITH(makeBall(-2), ContainsSubstring("radius of a ball = -2"));
  CHECK_THROWS_AS(makeBall(kNan), InvalidInput);
  CHECK_THROWS_AS(makeBox({1, 0, 1}), InvalidInput);
  CHECK_THROWS_AS(makeBox({1, 1, std::numeric_limits<Real>::infinity()}), InvalidInput);
  CHECK_THROWS_AS(makeCapsule(1, -1), InvalidInput);
  CHECK_THROWS_AS(makeCylinder(0, 1), InvalidInput);
  CHECK_THROWS_AS(makeDisc(-1), InvalidInput);
  CHECK(makeCapsule(0.5, 2).halfLength == 2);
}

TEST_CASE("a half-space keeps a normal of length one, whatever was given") {
  const HalfSpace floor = makeHalfSpace({0, 0, 1e200}, {5, 6, 7});
  CHECK(floor.normal == Vector3(0, 0, 1));
  CHECK(floor.offset == 7);
  CHECK_THROWS_AS(makeHalfSpace({0, 0, 0}, {0, 0, 0}), InvalidInput);
  CHECK_THROWS_AS(requireUsable(HalfSpace{{0, 0, 2}, 0}), InvalidInput);
}

TEST_CASE("a compound is refused as a whole if one part is bad") {
  CHECK_THROWS_AS(makeCompound({}), InvalidInput);
  CHECK_THROWS_AS(makeCompound({{Ball{1}, {}}, {Ball{-1}, {}}}), InvalidInput);
  CHECK_THROWS_AS(makeCompound({{ConvexHull{}, {}}}), InvalidInput);
  CHECK(makeCompound({{Ball{1}, {}}, {Box{}, {}}}).parts.size() == 2);
}

TEST_CASE("a polygon knows its outward normals") {
  const std::vector<Vector2> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const Polygon polygon = makePolygon(square);
  CHECK(polygon.normals[0] == Vector2(0, -1));
  CHECK(polygon.normals[1] == Vector2(1, 0));
  CHECK(polygon.normals[2] == Vector2(0, 1));
  CHECK(polygon.normals[3] == Vector2(-1, 0));
}

TEST_CASE("a polygon that is not convex is refused, and the corner named") {
  const std::vector<Vector2> dart = {{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}};
  CHECK_THROWS_WITH(makePolygon(dart), ContainsSubstring("corner = 2 at (0.5, 0.5)"));
  const std::vector<Vector2> clockwise = {{0, 0}, {0, 2}, {2, 2}, {2, 0}};
  CHECK_THROWS_AS(makePolygon(clockwise), InvalidInput);
  const std::vector<Vector2> straight = {{0, 0}, {1, 0}, {2, 0}, {0, 2}};
  CHECK_THROWS_AS(makePolygon(straight), InvalidInput);
  const std::vector<Vector2> doubled = {{0, 0}, {1, 0}, {1, 0}, {0, 2}};
  CHECK_THROWS_AS(makePolygon(doubled), InvalidInput);
  CHECK_THROWS_AS(makePolygon(std::vector<Vector2>{{0, 0}, {1, 0}}), InvalidInput);
  // A five-pointed star turns left at every corner and runs round twice.
  std::vector<Vector2> star;
  for (int i = 0; i < 5; ++i) {
    star.emplace_back(std::cos(0.8 * std::numbers::pi * i), std::sin(0.8 * std::numbers::pi * i));
  }
  CHECK_THROWS_WITH(makePolygon(star), ContainsSubstring("more than once"));
}
