// The first contact of solids that move and turn, against closed forms.

#include <cmath>
#include <limits>
#include <numbers>

#include "carom/core/elementary.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/toi/first_contact.hpp"
#include "support/cases.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

json toiCase(const std::string& id) {
  return readCase("toi", id);
}

Pose at(const Vector3& place) {
  return {Matrix3::Identity(), place};
}

Pose turnedAboutY(Real angle, const Vector3& place) {
  return poseOf(integrateOrientation({1, 0, 0, 0}, {0, angle, 0}, 1), place);
}

const HalfSpace kFloor = {Vector3::UnitZ(), 0};
const Sweep kAtRest;

bool isHit(const TimeOfImpact& t) {
  return t.status == ImpactStatus::kHit;
}

}  // namespace

TEST_CASE("T1: two balls in straight motion") {
  const json expected = toiCase("T1");
  Sweep moving;
  moving.start = at({10, 1, 2});
  moving.velocity = {-7, -0.5, -1};
  const TimeOfImpact hit = firstContact(Ball{1}, kAtRest, Ball{0.5}, moving, 10);
  REQUIRE(isHit(hit));
  CHECK(std::abs(hit.time / number(expected["time"]) - 1) < 1e-14);
  CHECK((hit.normal - vector(expected["normal"])).norm() < 1e-14);
  CHECK((hit.point - hit.normal).norm() < 1e-13);
  // It is over before it comes to that, or runs the other way.
  CHECK(firstContact(Ball{1}, kAtRest, Ball{0.5}, moving, 1.25).status == ImpactStatus::kNoHit);
  moving.velocity = -moving.velocity;
  CHECK(firstContact(Ball{1}, kAtRest, Ball{0.5}, moving, 10).status == ImpactStatus::kNoHit);
}

TEST_CASE("T4: a bullet and a thin wall") {
  Sweep bullet;
  bullet.start = at({-3, 0, 0});
  bullet.velocity = {900, 0, 0};
  Sweep wall;
  wall.start = at({0.006, 0, 0});
  const Real exact = number(toiCase("T4")["time"]);
  for (const Shape& target : {Shape(Box{{0.006, 1, 1}}), Shape(boxHull({0.006, 1, 1}))}) {
    const TimeOfImpact hit = firstContact(Ball{0.004}, bullet, target, wall, 1.0 / 60);
    REQUIRE(isHit(hit));
    CHECK(std::abs(hit.time / exact - 1) < 1e-13);
    CHECK(hit.time <= exact * (1 + 1e-15));
    CHECK((hit.normal - Vector3::UnitX()).norm() < 1e-14);
  }
}

TEST_CASE("T5: a thrown ball against a floor and a ball") {
  const json expected = toiCase("T5");
  Sweep thrown;
  thrown.start = at({0, 10, 0});
  thrown.velocity = {5, 3, 1};
  thrown.acceleration = {0, -9.81, 0};
  const HalfSpace floor = {Vector3::UnitY(), 0};
  const TimeOfImpact landed = firstContact(Ball{0.5}, thrown, floor, kAtRest, 5);
  REQUIRE(isHit(landed));
  CHECK(std::abs(landed.time / number(expected["floor_time"]) - 1) < 1e-14);
  CHECK((landed.normal + Vector3::UnitY()).norm() == 0);
  Sweep post;
  post.start = at({6, 8, 1});
  const TimeOfImpact hit = firstContact(Ball{0.5}, thrown, Ball{1}, post, 5);
  REQUIRE(isHit(hit));
  CHECK(std::abs(hit.time / number(expected["ball_time"]) - 1) < 1e-14);
  const Vector3 v = velocityAt(thrown, hit.time, poseAt(thrown, hit.time).p_WB);
  CHECK(std::abs(v.norm() / number(expected["speed_at_ball"]) - 1) < 1e-13);
}

TEST_CASE("T9: a rod that falls and turns") {
  const json expected = toiCase("T9");
  const Real radius = 0.125;  // the floor is lower by as much
  Sweep rod;
  rod.start = turnedAboutY(std::numbers::pi / 2 + 0.2, {0, 0, 1.2});
  rod.angularVelocity = {0, 6, 0};
  rod.acceleration = {0, 0, -9.81};
  const HalfSpace floor = {Vector3::UnitZ(), -radius};
  const TimeOfImpact hit = firstContact(Capsule{radius, 1}, rod, floor, kAtRest, 1);
  REQUIRE(isHit(hit));
  CHECK(std::abs(hit.time / number(expected["time"]) - 1) < 1e-13);
  CHECK(hit.steps < 10);
}

namespace {

// The point of T10 as a ball of a quarter metre, whose floor is lower by as much.
TimeOfImpact spinningPoint(Real z0, Real duration) {
  Sweep point;
  point.centre = {-0.5, 0, 0};
  point.start = turnedAboutY(0.1, Vector3::Zero());
  point.start.p_WB = Vector3(0, 0, z0) - point.start.R_WB * point.centre;
  point.velocity = {0, 0, -0.3};
  point.angularVelocity = {0, 20, 0};
  return firstContact(Ball{0.25}, point, HalfSpace{Vector3::UnitZ(), -0.25}, kAtRest, duration);
}

}  // namespace

TEST_CASE("T10: of many crossings the first is found") {
  const TimeOfImpact hit = spinningPoint(0.8, 5);
  REQUIRE(isHit(hit));
  CHECK(std::abs(hit.time / number(toiCase("T10")["time"]) - 1) < 1e-13);
}

TEST_CASE("T11: a graze by 1e-12 m is a hit, a miss by 1e-12 m is none") {
  const json expected = toiCase("T11");
  const Real tangent = number(expected["tangent_start"]);
  const TimeOfImpact hit = spinningPoint(tangent - 1e-12, 0.2);
  REQUIRE(isHit(hit));
  CHECK(std::abs(hit.time - number(expected["time"])) < 1e-9);
  CHECK(spinningPoint(tangent + 1e-12, 0.2).status == ImpactStatus::kNoHit);
}

TEST_CASE("T12: a blade that turns by 48 degrees in a step hits a small ball") {
  const Real exact = number(toiCase("T12")["time"]);
  // A segment as a capsule of half the ball's radius, along x at the start.
  Sweep blade;
  blade.start.R_WB = turnedAboutY(std::numbers::pi / 2, Vector3::Zero()).R_WB;
  blade.start.p_WB = {0.5, 0, 0};
  blade.centre = {0, 0, -0.5};
  blade.angularVelocity = {0, 0, 50};
  Sweep ball;
  ball.start = at({0.6, 0.6, 0});
  const TimeOfImpact hit = firstContact(Capsule{0.025, 0.5}, blade, Ball{0.025}, ball, 1.0 / 60);
  REQUIRE(isHit(hit));
  CHECK(std::abs(hit.time / exact - 1) < 1e-13);
}

TEST_CASE("T15: a box that tumbles onto a floor") {
  const json expected = toiCase("T15");
  Sweep box;
  box.start = at({0, 0, 1.4});
  box.velocity = {0, 0, -2};
  box.acceleration = {0, 0, -9.81};
  box.angularVelocity = 4 * Vector3(1, 2, 2) / 3;
  for (const Shape& shape : {Shape(Box{{0.5, 0.3, 0.2}}), Shape(boxHull({0.5, 0.3, 0.2}))}) {
    const TimeOfImpact hit = firstContact(shape, box, kFloor, kAtRest, 1);
    REQUIRE(isHit(hit));
    CHECK(std::abs(hit.time / number(expected["time"]) - 1) < 1e-12);
    const Vector3 centre = poseAt(box, hit.time).p_WB;
    CHECK((hit.point - centre - vector(expected["arm"])).norm() < 1e-12);
    CHECK(hit.steps < 10);
  }
  // A large box in place of the half-space gives the same.
  Sweep slab;
  slab.start = at({0, 0, -1});
  const TimeOfImpact hit = firstContact(Box{{0.5, 0.3, 0.2}}, box, Box{{9, 9, 1}}, slab, 1);
  REQUIRE(isHit(hit));
  CHECK(std::abs(hit.time / number(expected["time"]) - 1) < 1e-12);
}
