// Closed forms, conservative advancement, and looking more often.

#include <cmath>
#include <limits>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/toi/conservative_advancement.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/toi/sub_steps.hpp"
#include "carom/toi/swept_ball_plane.hpp"
#include "carom/toi/swept_balls.hpp"
#include "carom/toi/tunnels.hpp"
#include "support/cases.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();

TimeOfImpact sweptFrom(const Vector3& place, const Vector3& velocity, Real radii, Real duration) {
  return sweptBalls({.radius = radii / 4}, {radii * 3 / 4, place, velocity}, duration);
}

}  // namespace

TEST_CASE("T1: two balls in straight motion, in closed form") {
  const json expected = readCase("toi", "T1");
  const TimeOfImpact hit = sweptFrom({10, 1, 2}, {-7, -0.5, -1}, 1.5, 10);
  REQUIRE(hit.status == ImpactStatus::kHit);
  CHECK(std::abs(hit.time / number(expected["time"]) - 1) < 1e-15);
  CHECK((hit.normal - vector(expected["normal"])).norm() < 1e-15);
  CHECK(std::abs(hit.gap) < 2e-15);
  CHECK(sweptFrom({10, 1, 2}, {-7, -0.5, -1}, 1.5, 1.25).status == ImpactStatus::kNoHit);
  CHECK(sweptFrom({10, 1, 2}, {7, 0.5, 1}, 1.5, 10).status == ImpactStatus::kNoHit);
  CHECK(sweptFrom({1, 1, 0}, {7, 0.5, 1}, 1.5, 10).status == ImpactStatus::kOverlapping);
  CHECK(sweptFrom({1.5, 0, 0}, {1, 0, 0}, 1.5, 10).status == ImpactStatus::kHit);
  CHECK(sweptFrom({2, 0, 0}, {0, 0, 0}, 1.5, 10).status == ImpactStatus::kNoHit);
}

TEST_CASE("T2: balls that graze, or are close already") {
  const json expected = readCase("toi", "T2");
  const Real tiny = std::ldexp(1.0, -40);
  const TimeOfImpact graze = sweptFrom({1000, 1 - tiny, 0}, {-1, 0, 0}, 1, 2000);
  REQUIRE(graze.status == ImpactStatus::kHit);
  CHECK(std::abs(graze.time / number(expected["grazing_time"]) - 1) < 1e-15);
  const TimeOfImpact close = sweptFrom({1 + std::ldexp(1.0, -30), 0, 0}, {-1000, 0, 0}, 1, 1);
  REQUIRE(close.status == ImpactStatus::kHit);
  CHECK(std::abs(close.time / number(expected["near_time"]) - 1) < 1e-15);
  CHECK(sweptFrom({1000, 1 + tiny, 0}, {-1, 0, 0}, 1, 2000).status == ImpactStatus::kNoHit);
  // Grazing without any room is a hit, one ulp more is none.
  CHECK(sweptFrom({1000, 1, 0}, {-1, 0, 0}, 1, 2000).status == ImpactStatus::kHit);
  CHECK(sweptFrom({1000, std::nextafter(1.0, 2.0), 0}, {-1, 0, 0}, 1, 2000).status ==
        ImpactStatus::kNoHit);
}

TEST_CASE("T3: the two cars of the source") {
  const json expected = readCase("toi", "T3");
  const Real speed = 72, dt = 0.1;
  CHECK(speed * dt == number(expected["step_length"]));
  CHECK_FALSE(tunnels(3.6, 3.6, speed, dt));  // they touch, at least
  CHECK_FALSE(tunnels(3.6, 3.6, 60, dt));     // the source's six metres
  CHECK(tunnels(3.6, 3.6, speed, 0.11));
  CHECK(tunnels(3.6, 3.6, -speed, 0.11));
  CHECK_FALSE(tunnels(3.6, 3.6, 432, 1.0 / 60));
  CHECK(tunnels(3.6, 3.6, 433, 1.0 / 60));
  const TimeOfImpact hit =
      conservativeAdvancement([&](Real t) { return 0.05 - speed * t; }, speed, dt, 1e-15);
  REQUIRE(hit.status == ImpactStatus::kHit);
  CHECK(std::abs(hit.time / number(expected["time"]) - 1) < 1e-13);
  CHECK_THROWS_WITH(tunnels(-1, 1, 1, 1), ContainsSubstring("lengthA = -1"));
}

TEST_CASE("T5: a thrown ball against a floor, in closed form") {
  const MovingBall ball = {0.5, {0, 10, 0}, {5, 3, 1}};
  const HalfSpace floor = {Vector3::UnitY(), 0};
  const Vector3 gravity(0, -9.81, 0);
  const Real exact = number(readCase("toi", "T5")["floor_time"]);
  const TimeOfImpact hit = sweptBallPlane(ball, gravity, floor, 5);
  REQUIRE(hit.status == ImpactStatus::kHit);
  CHECK(std::abs(hit.time / exact - 1) < 1e-15);
  CHECK(std::abs(hit.point.y()) < 1e-14);
  CHECK(sweptBallPlane(ball, gravity, floor, 1.7).status == ImpactStatus::kNoHit);
  CHECK(sweptBallPlane(ball, -gravity, floor, 5).status == ImpactStatus::kNoHit);
  // Thrown downwards with a brake that is just not enough, and one that is.
  const MovingBall down = {0.5, {0, 1.5, 0}, {0, -2, 0}};
  CHECK(sweptBallPlane(down, {0, 2, 0}, floor, 5).time == 1);
  CHECK(sweptBallPlane(down, {0, 2.001, 0}, floor, 5).status == ImpactStatus::kNoHit);
  // Without pull it is a straight line; in the floor it is an overlap; in touch a hit.
  CHECK(sweptBallPlane(down, {0, 0, 0}, floor, 5).time == 0.5);
  CHECK(sweptBallPlane({0.5, {0, 0.25, 0}, {0, 1, 0}}, gravity, floor, 5).status ==
        ImpactStatus::kOverlapping);
  CHECK(sweptBallPlane({0.5, {0, 0.5, 0}, {0, 1, 0}}, gravity, floor, 5).time == 0);
}

TEST_CASE("balls in closed form and by the general way agree") {
  Random random(31);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const MovingBall a = {random.between(0.1, 1), random.vector(3), random.vector(4)};
    const MovingBall b = {random.between(0.1, 1), random.vector(3), random.vector(4)};
    Sweep A, B;
    A.start.p_WB = a.centre;
    A.velocity = a.velocity;
    B.start.p_WB = b.centre;
    B.velocity = b.velocity;
    B.angularVelocity = random.vector(9);  // a ball does not mind
    const TimeOfImpact closed = sweptBalls(a, b, 1);
    const TimeOfImpact searched = firstContact(Ball{a.radius}, A, Ball{b.radius}, B, 1);
    REQUIRE(closed.status == searched.status);
    if (closed.status != ImpactStatus::kHit) continue;
    ++hits;
    const Real closing = closed.normal.dot(a.velocity - b.velocity);
    INFO("time " << closed.time << ", off by " << searched.time - closed.time);
    CHECK(searched.time <= closed.time + 1e-15);
    CHECK(closed.time - searched.time <= 1e-13 / std::max(closing, 1e-3));
  }
  CHECK(hits > 50);
}

TEST_CASE("a gap that closes as fast as said takes one step, half as fast many") {
  const auto gap = [](Real t) { return 1 - t; };
  const TimeOfImpact tight = conservativeAdvancement(gap, 1, 2, 1e-9);
  CHECK(tight.status == ImpactStatus::kHit);
  CHECK(tight.time == 1);
  CHECK(tight.steps == 1);
  const TimeOfImpact loose = conservativeAdvancement(gap, 2, 2, 1e-9);
  CHECK(loose.steps == 30);
  CHECK(loose.time < 1);
  CHECK(loose.gap <= 1e-9);
  CHECK(conservativeAdvancement(gap, 1, 0.9, 1e-9).status == ImpactStatus::kNoHit);
  CHECK(conservativeAdvancement(gap, 1, 1, 1e-9).status == ImpactStatus::kHit);  // at the very end
  CHECK(conservativeAdvancement(gap, 50, 2, 1e-9, 20).status == ImpactStatus::kLimit);
  CHECK(conservativeAdvancement([](Real) { return -1.0; }, 1, 1, 1e-9).status ==
        ImpactStatus::kOverlapping);
  CHECK_THROWS_AS(conservativeAdvancement(gap, 0, 1, 1e-9), InvalidInput);
  CHECK_THROWS_AS(conservativeAdvancement(gap, 1, 1, 0), InvalidInput);
  CHECK_THROWS_AS(conservativeAdvancement({}, 1, 1, 1e-9), InvalidInput);
  CHECK_THROWS_AS(conservativeAdvancement([](Real) { return kNan; }, 1, 1, 1e-9), InvalidInput);
}

TEST_CASE("as many looks as the rule asks for see every overlap that is deep enough") {
  Sweep bullet;
  bullet.start.p_WB = {-3, 0, 0};
  bullet.velocity = {900, 0, 0};
  const Sweep wall;
  const Box plate{{0.006, 1, 1}};
  const Ball ball{0.004};
  // Once in a step sees nothing; the rule asks for half of the bullet's own thickness.
  CHECK(contactBySubSteps(ball, bullet, plate, wall, 1.0 / 60, 1, 1e-9).status ==
        ImpactStatus::kNoHit);
  const int parts = subStepsFor(ball, bullet, plate, wall, 1.0 / 60, 0.004);
  CHECK(parts == 1875);
  const TimeOfImpact seen = contactBySubSteps(ball, bullet, plate, wall, 1.0 / 60, parts, 1e-9);
  REQUIRE(seen.status == ImpactStatus::kHit);
  CHECK(std::abs(seen.time - 2.99 / 900) < 1e-11);
  CHECK(seen.time <= 2.99 / 900);
  // Out of reach, no look is needed.
  bullet.velocity = {100, 0, 0};
  CHECK(subStepsFor(ball, bullet, plate, wall, 1.0 / 60, 0.004) == 0);
  CHECK_THROWS_WITH(subStepsFor(ball, bullet, plate, wall, 1, 1e-12),
                    ContainsSubstring("less than 2^31"));
}

TEST_CASE("searches that cannot be are refused") {
  const Sweep still;
  Sweep turning;
  turning.angularVelocity = {0, 0, 1};
  const HalfSpace floor;
  CHECK_THROWS_WITH(firstContact(floor, turning, Ball{1}, still, 1),
                    ContainsSubstring("angularVelocity of a half-space"));
  CHECK_THROWS_WITH(firstContact(floor, still, floor, still, 1),
                    ContainsSubstring("two half-spaces"));
  CHECK_THROWS_WITH(firstContact(Ball{1}, still, Ball{1}, still, -1),
                    ContainsSubstring("duration = -1"));
  CHECK_THROWS_AS(firstContact(Ball{1}, still, Ball{1}, still, 1, {.tolerance = kNan}),
                  InvalidInput);
  CHECK_THROWS_AS(firstContact(Ball{1}, still, Ball{1}, still, 1, {.maxSteps = 0}), InvalidInput);
  Sweep wild;
  wild.velocity = {1e300, 0, 0};
  CHECK_THROWS_WITH(firstContact(Ball{1}, wild, Ball{1}, still, 1),
                    ContainsSubstring("the way of A = 1e+300"));
  wild = {};
  wild.angularVelocity = {0, 1e200, 0};
  CHECK_THROWS_WITH(firstContact(Ball{1}, wild, Ball{1}, still, 1),
                    ContainsSubstring("A.angularVelocity"));
  CHECK_THROWS_AS(sweptBalls({.radius = -1}, {}, 1), InvalidInput);
  CHECK_THROWS_AS(sweptBalls({}, {.velocity = {0, kNan, 0}}, 1), InvalidInput);
}
