// Motions whose events are located: blocks that stop, balls that begin to roll, balls that bounce.
// And what the air and gears do.

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/detection/convex_hull.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/impulse/block_on_slope.hpp"
#include "carom/impulse/bouncing_ball.hpp"
#include "carom/impulse/gears.hpp"
#include "carom/impulse/projected_area.hpp"
#include "carom/impulse/roll_ball.hpp"
#include "carom/impulse/slide_block.hpp"
#include "carom/impulse/sliding_disc.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {
constexpr Real kPi = std::numbers::pi;

// Plain sums over rings and angles of the disc: the integrals themselves.
DiscFriction bySums(Real ratio) {
  constexpr int kRings = 400, kAngles = 800;
  DiscFriction f;
  for (int i = 0; i < kRings; ++i) {
    const Real r = (i + 0.5) / kRings;
    for (int k = 0; k < kAngles; ++k) {
      const Real angle = 2 * kPi * (k + 0.5) / kAngles;
      // Flight along x with speed `ratio`, spin 1 about z: the slip at (r, angle).
      const Real sx = ratio - r * std::sin(angle), sy = r * std::cos(angle);
      const Real share = 2 * r / kRings / kAngles / std::hypot(sx, sy);
      f.force += share * sx;
      f.torque += share * r * (std::cos(angle) * sy - std::sin(angle) * sx);
    }
  }
  return f;
}
}  // namespace

TEST_CASE("a block reaches its stop in one step or in a thousand, and stays there") {
  const Slope level{.friction = 0.3};
  const SlidingBlock start{0, 4};
  const Real end = timeToStop(start, level) * 1.7;
  const SlidingBlock once = slideBlock(start, level, end);
  CHECK(once.velocity == 0);
  for (const int steps : {7, 60, 1000}) {
    SlidingBlock block = start;
    for (int i = 0; i < steps; ++i) block = slideBlock(block, level, end / steps);
    CHECK(block.velocity == 0);
    CHECK(std::abs(block.position - once.position) < 1e-13);
  }
  CHECK(slideBlock(once, level, 100).position == once.position);
}

TEST_CASE("a block pushed uphill comes back only if the slope is steep enough") {
  const Slope steep{.angle = 0.6, .friction = 0.5}, flat{.angle = 0.4, .friction = 0.5};
  const SlidingBlock up{0, -3};
  CHECK(slideBlock(up, steep, 10).velocity > 0);
  const SlidingBlock stuck = slideBlock(up, flat, 10);
  CHECK(stuck.velocity == 0);
  CHECK(near(stuck.position, -4.5 / (9.81 * (std::sin(0.4) + 0.5 * std::cos(0.4)))));
  CHECK(std::isinf(timeToStop({0, 3}, steep)));
  CHECK_THROWS_WITH(slideBlock(up, Slope{.friction = -1}, 1), ContainsSubstring("friction = -1"));
  CHECK_THROWS_AS(slideBlock(up, steep, -1), InvalidInput);
  CHECK_THROWS_AS(slideBlock(up, Slope{.angle = 2}, 1), InvalidInput);
}

TEST_CASE("energy of a sliding ball only falls, and in one step or many it rolls alike") {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const TableLaw law{.radius = random.between(0.02, 2), .friction = random.between(0.05, 1)};
    TableBall ball;
    ball.velocity = {random.between(-3, 3), random.between(-3, 3)};
    ball.angularVelocity = random.vector(20);
    const Real end = 1.3 * timeToRoll(ball, law);
    const TableBall once = rollBall(ball, law, end);
    const auto energy = [&](const TableBall& b) {
      const Real k = law.gyration * law.radius * law.radius;
      return b.velocity.squaredNorm() + k * b.angularVelocity.squaredNorm();
    };
    TableBall stepped = ball;
    INFO("seed 7, ball " << i);
    for (int n = 0; n < 50; ++n) {
      const TableBall next = rollBall(stepped, law, end / 50);
      REQUIRE(energy(next) <= energy(stepped) * (1 + 1e-14));
      stepped = next;
    }
    const Real scale = ball.velocity.norm() + law.radius * ball.angularVelocity.norm();
    REQUIRE((stepped.position - once.position).norm() < 1e-13 * (1 + scale * end));
    REQUIRE((stepped.velocity - once.velocity).norm() < 1e-14 * scale);
    REQUIRE(slipOf(once, law).norm() <= 4 * kUlp * scale);
    REQUIRE(once.angularVelocity.z() == ball.angularVelocity.z());
  }
}

TEST_CASE("without friction a ball slides for ever, and one that rolls goes on") {
  TableBall ball;
  ball.velocity = {1, 2};
  CHECK(std::isinf(timeToRoll(ball, {.friction = 0})));
  CHECK(rollBall(ball, {.friction = 0}, 3).position == Vector2(3, 6));
  ball.angularVelocity = {-2, 1, 0};  // rolls: w = z x v / R
  CHECK(timeToRoll(ball, {}) == 0);
  CHECK(rollBall(ball, {}, 3).position == Vector2(3, 6));
  CHECK_THROWS_WITH(rollBall(ball, {.radius = 0}, 1), ContainsSubstring("radius = 0"));
}

TEST_CASE("a bouncing ball is where stepping from impact to impact finds it") {
  const BounceLaw law{.restitution = 0.7};
  const BouncingBall start{1, 2};
  BouncingBall now = start;
  Real time = 0;
  for (int n = 1; n <= 20; ++n) {
    const Real fall =
        (now.velocity + std::sqrt(now.velocity * now.velocity + 2 * law.gravity * now.height)) /
        law.gravity;
    const Real middle = time + fall / 2;
    const BouncingBall got = bounceBall(start, law, middle);
    CHECK(std::abs(got.height -
                   (now.height + now.velocity * fall / 2 - law.gravity * fall * fall / 8)) < 1e-14);
    CHECK(std::abs(got.velocity - (now.velocity - law.gravity * fall / 2)) < 1e-13);
    time += fall;
    CHECK(std::abs(impactTime(start, law, n) - time) < 1e-14);
    now = {0, -law.restitution * (now.velocity - law.gravity * fall)};
  }
  CHECK(bounceBall(start, law, restTime(start, law)).height == 0);
  CHECK(bounceBall(start, law, 1e9).velocity == 0);
  // e = 1 never ends; e = 0 ends at once.
  CHECK(std::isinf(restTime(start, {.restitution = 1})));
  CHECK(bounceBall(start, {.restitution = 1}, 1e3).height <= 1 + 4 / (2 * 9.81) + 1e-9);
  CHECK(restTime(start, {.restitution = 0}) == impactTime(start, {.restitution = 0}, 1));
  CHECK_THROWS_AS(bounceBall(start, {.restitution = 1.1}, 1), InvalidInput);
  CHECK_THROWS_AS(impactTime(start, law, 0), InvalidInput);
}

TEST_CASE("a block on a slope rests, slides or tips; a ball rolls or slips") {
  CHECK(blockOnSlope(1, 1, {.angle = 0.3, .friction = 0.5}).fate == BlockFate::rests);
  CHECK(blockOnSlope(1, 1, {.angle = 0.6, .friction = 0.5}).fate == BlockFate::slides);
  CHECK(blockOnSlope(1, 3, {.angle = 0.5, .friction = 1}).fate == BlockFate::tips);
  const BallOnSlope slipping = ballOnSlope(0.4, {.angle = 1.2, .friction = 0.2});
  CHECK(slipping.slips);
  CHECK(near(slipping.acceleration, 9.81 * (std::sin(1.2) - 0.2 * std::cos(1.2)), 4));
  CHECK_FALSE(ballOnSlope(0.4, {.angle = 0.5, .friction = 0.2}).slips);
  CHECK_THROWS_AS(ballOnSlope(0, {}), InvalidInput);
  CHECK_THROWS_AS(blockOnSlope(1, -1, {}), InvalidInput);
}

TEST_CASE("friction of a disc is the sum over its parts") {
  for (const Real x : {0.01, 0.3, 0.7, 1.3, 2.5, 8.0}) {
    const DiscFriction got = discFriction(x), expected = bySums(x);
    CHECK(std::abs(got.force - expected.force) < 2e-5);
    CHECK(std::abs(got.torque - expected.torque) < 2e-5);
  }
  // The two closed forms meet at one; the series takes over at two; the ends are those of pure
  // spin and pure flight.
  for (const Real x : {1.0, 2.0}) {
    const DiscFriction below = discFriction(x * (1 - 1e-9)), above = discFriction(x * (1 + 1e-9));
    CHECK(std::abs(below.force - above.force) < 1e-7);
    CHECK(std::abs(below.torque - above.torque) < 1e-7);
    CHECK(std::abs(discFriction(x).torque - above.torque) < 1e-7);
  }
  CHECK(discFriction(0).torque == 2.0 / 3);
  CHECK(near(discFriction(1e-9).force, 1e-9, 100));
  CHECK(near(discFriction(1e9).torque, 0.25e-9, 100));
  CHECK(discFriction(std::numeric_limits<Real>::infinity()).force == 1);
  // From the smallest ratios to the largest, force never falls and torque never rises.
  DiscFriction before{0, 2.0 / 3};
  for (Real digits = -300; digits < 300; digits += 0.0625) {
    const DiscFriction now = discFriction(std::pow(10, digits));
    INFO("ratio 1e" << digits);
    REQUIRE(now.force >= before.force * (1 - 1e-14));
    REQUIRE(now.force <= 1 + 1e-14);
    REQUIRE(now.torque <= before.torque * (1 + 1e-13));
    REQUIRE(now.torque >= 0);
    before = now;
  }
  CHECK_THROWS_AS(discFriction(-0.1), InvalidInput);
}

TEST_CASE("a disc that only spins or only flies stops as each friction says") {
  const DiscStop spun = stopOfDisc({.spin = 50, .radius = 0.1, .friction = 0.25});
  CHECK(near(spun.time, 3 * 0.1 * 50 / (4 * 0.25 * 9.81)));
  CHECK(spun.distance == 0);
  const DiscStop flown = stopOfDisc({.speed = 4, .radius = 0.1, .friction = 0.3});
  CHECK(near(flown.distance, 16 / (2 * 0.3 * 9.81)));
  CHECK(std::isinf(flown.ratio));
  // Whatever the start, flight and spin end together; spin makes it fly further.
  for (const Real speed : {0.01, 0.5, 3.0, 40.0}) {
    const DiscStop stop = stopOfDisc({.speed = speed, .spin = 5, .radius = 0.2, .friction = 0.3});
    CHECK(std::abs(stop.ratio - 0.6530017892055976) < 1e-9);
    CHECK(stop.distance > speed * speed / (2 * 0.3 * 9.81));
  }
  CHECK_THROWS_AS(stopOfDisc({.speed = -1}), InvalidInput);
}

TEST_CASE("shadows: a box's faces, a ball's disc, and half of a hull's faces") {
  const Box box{{1, 2, 3}};
  CHECK(projectedArea(box, {1, 0, 0}) == 24);
  CHECK(projectedArea(box, {0, 0, -7}) == 8);
  CHECK(projectedArea(Ball{2}, {1, 2, 3}) == 4 * kPi);
  CHECK(near(projectedArea(Cylinder{1, 2}, {0, 0, 1}), kPi));
  CHECK(near(projectedArea(Cylinder{1, 2}, {3, 4, 0}), 8));
  CHECK(near(projectedArea(Capsule{1, 2}, {1, 0, 0}), kPi + 8));
  CHECK(near(projectedArea(Capsule{1, 2}, {0, 0, 1}), kPi));
  // The box as a hull, from any side.
  std::vector<Vector3> corners;
  for (const Real x : {-1.0, 1.0}) {
    for (const Real y : {-2.0, 2.0}) {
      for (const Real z : {-3.0, 3.0}) corners.emplace_back(x, y, z);
    }
  }
  const ConvexHull hull = hullOfPoints(corners);
  Random random(34);
  for (int i = 0; i < 200; ++i) {
    const Vector3 d = random.direction();
    REQUIRE(near(projectedArea(hull, d), projectedArea(box, 5 * d), 8));
  }
  CHECK_THROWS_WITH(projectedArea(box, {0, 0, 0}), ContainsSubstring("must not be zero"));
}

TEST_CASE("Cauchy: the mean shadow of a convex body is a quarter of its surface") {
  const Box box{{0.5, 1, 2}};
  Random random(1841);
  Real sum = 0;
  constexpr int kDirections = 20000;
  for (int i = 0; i < kDirections; ++i) sum += projectedArea(box, random.direction());
  CHECK(std::abs(sum / kDirections - 8 * (0.5 + 1 + 2) / 4) < 0.02);
}

TEST_CASE("erratum 6.8: a gear counts with the square of the ratio") {
  CHECK(meshedInertia(1, 10, 16, 40) == 2);  // not 67, as with Steiner
  CHECK(meshedInertia(16, 40, 1, 10) == 32);
  CHECK_THROWS_AS(meshedInertia(1, 0, 1, 10), InvalidInput);
  CHECK_THROWS_AS(meshedInertia(-1, 10, 1, 10), InvalidInput);
}

TEST_CASE("gears pushed into mesh turn together, with the inertia that both feel") {
  Gear small{1, 1, 6}, large{16, 4, 0};
  const Real impulse = meshGears(small, large);
  CHECK(near(small.angularVelocity, 3));  // half of it: I_eff is 2, and 1 of that turned before
  CHECK(near(large.angularVelocity, -0.75));
  CHECK(near(small.angularVelocity * 1, -large.angularVelocity * 4));
  CHECK(near(impulse, -3));
  CHECK(std::abs(meshGears(small, large)) < 1e-15);
  Gear broken{1, 0, 1};
  CHECK_THROWS_WITH(meshGears(small, broken), ContainsSubstring("radius = 0"));
}
