// The world advances by steps that its error asks for. Places are asked for at the end of the time,
// and compared with closed forms.

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/impulse/bouncing_ball.hpp"
#include "carom/impulse/roll_ball.hpp"
#include "carom/motion/free_rotor.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"

namespace {

using namespace carom_test;

// A box that stands on its left edge, tips to the right, and falls on nothing.
World tippingBox() {
  World world(awake());
  addPlane(world, 4, 0);
  const Vector3 spin(0, 1.2, 0), centre(-0.1, 0, 0.5);
  addBox(world, {0.1, 0.25, 0.5},
         {.position = centre,
          .velocity = cross(spin, centre),
          .angularVelocity = spin,
          .friction = 4});
  return world;
}

Real tiltOf(const World& world) {
  const Quaternion q = world.orientation(world.bodies()[1]);
  return 2 * std::atan2(q.y, q.w);
}

}  // namespace

TEST_CASE("advance refuses times and tolerances that are none, and changes nothing") {
  World world(awake());
  addBall(world, 0.5, {.velocity = {1, 2, 3}});
  const std::uint64_t before = world.hash();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Real infinite = std::numeric_limits<Real>::infinity();
  for (const Real bad : {0.0, -1.0, nan, infinite}) {
    CHECK_THROWS_AS(world.advance(bad, 1e-6), InvalidInput);
    CHECK_THROWS_AS(world.advance(1, bad), InvalidInput);
    CHECK_THROWS_WITH(world.advance(bad, 1e-6), ContainsSubstring("duration"));
    CHECK_THROWS_WITH(world.advance(1, bad), ContainsSubstring("tolerance"));
  }
  CHECK(world.hash() == before);
  CHECK(world.time() == 0);
  WorldSettings settings;
  settings.shortestSubStep = 0;
  CHECK_THROWS_WITH(World(settings), ContainsSubstring("shortestSubStep"));
  settings = WorldSettings();
  settings.phaseTurn = 0;
  CHECK_THROWS_WITH(World(settings), ContainsSubstring("phaseTurn"));
}

TEST_CASE("free flight and free rotation of any length are one step") {
  World world(weightless());
  const BodyId box = addBox(world, {0.5, 1, 1.5}, {.mass = 6, .angularVelocity = {0.01, 5, 0.01}});
  const FreeRotor exact(Vector3(6.5, 5, 2.5), {Quaternion{}, Vector3(0.01, 5, 0.01)});
  world.advance(100, 1e-6);
  CHECK(world.counters().subSteps == 0);
  CHECK(world.counters().macroSteps == 1);
  const Quaternion q = world.orientation(box), p = exact.at(100).q_WB;
  CHECK_THAT(std::abs(q.w * p.w + q.x * p.x + q.y * p.y + q.z * p.z), WithinAbs(1, 1e-12));
  CHECK(world.time() == 100);
}

TEST_CASE("a bouncing ball comes to rest in finite time, whatever the tolerance") {
  for (const Real tolerance : {1e-3, 1e-6, 1e-9}) {
    World world(awake());
    addPlane(world, 0, 0.8);
    const BodyId ball = addBall(world, 0.5, {.position = {0, 0, 5.5}, .restitution = 0.8});
    world.advance(5, tolerance);
    const BouncingBall exact = bounceBall({5, 0}, {0.8, kGravity}, 5);
    CHECK_THAT(world.position(ball).z() - 0.5, WithinAbs(exact.height, 1e-12));
    world.advance(6, tolerance);
    INFO("tolerance " << tolerance);
    CHECK(world.counters().impacts < 150);
    CHECK_THAT(world.position(ball).z(), WithinAbs(0.5, tolerance));
    CHECK(world.velocity(ball).norm() < 1e-12);
  }
}

TEST_CASE("impacts say when they were from the start of the time") {
  World world(awake());
  addPlane(world, 0, 1);
  addBall(world, 0.5, {.position = {0, 0, 5.5}, .restitution = 1});
  const Real fall = std::sqrt(10 / kGravity);
  world.advance(6, 1e-6);
  REQUIRE(world.events().impacts.size() == 3);
  for (int i = 0; i < 3; ++i) {
    CHECK_THAT(world.events().impacts[static_cast<std::size_t>(i)].time,
               WithinAbs((2 * i + 1) * fall, 1e-9));
  }
}

TEST_CASE("a ball slides and then rolls, right in a few steps") {
  World world(awake());
  addPlane(world, 0.3, 0);
  const BodyId ball =
      addBall(world, 0.5, {.position = {0, 0, 0.5}, .velocity = {5, 0, 0}, .friction = 0.3});
  world.advance(5, 1e-9);
  const TableBall exact = rollBall({{0, 0}, {5, 0}, Vector3::Zero()},
                                   {.radius = 0.5, .friction = 0.3, .gravity = kGravity}, 5);
  CHECK_THAT(world.position(ball).x(), WithinAbs(exact.position.x(), 3e-9));
  CHECK_THAT(world.velocity(ball).x(), WithinAbs(exact.velocity.x(), 3e-9));
  CHECK(world.counters().subSteps < 50);
}

TEST_CASE("a box that tips over its edge is as right as it is asked to be") {
  World fine = tippingBox();
  fine.advance(0.5, 1e-9);
  // The energy is known at every angle.
  const Real tilt = tiltOf(fine), inertia = (1 + 0.04) / 3;
  const Real lifted = 0.5 * std::cos(tilt) + 0.1 * std::sin(tilt) - 0.5;
  const Real spin = std::sqrt(1.2 * 1.2 - 2 * kGravity / inertia * lifted);
  CHECK_THAT(fine.angularVelocity(fine.bodies()[1]).y(), WithinAbs(spin, 1e-8));
  std::int64_t last = 0;
  for (const Real tolerance : {1e-3, 1e-5, 1e-7}) {
    World world = tippingBox();
    world.advance(0.5, tolerance);
    INFO("tolerance " << tolerance);
    CHECK_THAT(tiltOf(world), WithinAbs(tilt, 3 * tolerance));
    CHECK((world.position(world.bodies()[1]) - fine.position(fine.bodies()[1])).norm() <
          3 * tolerance);
    CHECK(world.counters().subSteps > last);
    last = world.counters().subSteps;
  }
}

TEST_CASE("without extrapolation the same accuracy costs many more steps") {
  World with = tippingBox();
  with.advance(0.2, 1e-6);
  WorldSettings settings = with.settings();
  settings.extrapolation = false;
  World without = tippingBox();
  without.change(settings);
  without.advance(0.2, 1e-6);
  CHECK_THAT(tiltOf(without), WithinAbs(tiltOf(with), 6e-6));
  CHECK(without.counters().subSteps > 3 * with.counters().subSteps);
}

TEST_CASE("a quiet island does not pay for a violent one") {
  const auto stepsOf = [](bool quiet, bool violent) {
    World world(awake());
    addPlane(world, 4, 0);
    if (quiet) {
      addBox(world, Vector3::Constant(0.5),
             {.position = {50, 0, 0.5}, .velocity = {2, 0, 0}, .friction = 0.1});
    }
    if (violent) {
      const Vector3 spin(0, 1.2, 0), centre(-0.1, 0, 0.5);
      addBox(world, {0.1, 0.25, 0.5},
             {.position = centre,
              .velocity = cross(spin, centre),
              .angularVelocity = spin,
              .friction = 4});
    }
    world.advance(0.3, 1e-6);
    return world.counters().subSteps;
  };
  const std::int64_t alone = stepsOf(false, true), quiet = stepsOf(true, false);
  CHECK(quiet <= 3);
  CHECK(alone > 20 * quiet);
  CHECK(stepsOf(true, true) == alone + quiet);
}

TEST_CASE("bodies far apart at the start of a long time meet in it") {
  // Three balls: the first strikes the second at 2 s, this one the third 3 s later.
  World world(weightless());
  const BodyId a = addBall(world, 0.5, {.velocity = {2, 0, 0}, .restitution = 1});
  const BodyId b = addBall(world, 0.5, {.position = {5, 0, 0}, .restitution = 1});
  const BodyId c = addBall(world, 0.5, {.position = {12, 0, 0}, .restitution = 1});
  world.advance(10, 1e-9);
  CHECK_THAT(world.position(a).x(), WithinAbs(4, 1e-8));
  CHECK_THAT(world.position(b).x(), WithinAbs(11, 1e-8));
  CHECK_THAT(world.position(c).x(), WithinAbs(12 + 2 * 5.0, 1e-8));
  CHECK(world.counters().impacts == 2);
}

TEST_CASE("a top precesses about its tip, as right as it is asked to") {
  // Steady precession of a symmetric top about its tip, at the rate w of
  // A cos(lean) w^2 - C spin w + m g l = 0 (Goldstein, Classical Mechanics, 5.7).
  const Real l = 0.5, lean = 0.3, spin = 60, about = 0.1, across = 0.08, A = across + l * l;
  const Real half = about * spin / (2 * A * std::cos(lean));
  const Real rate = half - std::sqrt(half * half - kGravity * l / (A * std::cos(lean)));
  const Real own = spin - rate * std::cos(lean);  // about its axis, beside the precession
  const auto lies = [&](Real time) {
    return hamiltonProduct(axisAngleToQuaternion({0, 0, 1}, rate * time),
                           hamiltonProduct(axisAngleToQuaternion({0, 1, 0}, lean),
                                           axisAngleToQuaternion({0, 0, 1}, own * time)));
  };
  const auto axis = [&](Real time) {
    return Vector3(std::sin(lean) * std::cos(rate * time), std::sin(lean) * std::sin(rate * time),
                   std::cos(lean));
  };
  std::vector<Vector3> corners{{0, 0, -l}};
  for (int k = 0; k < 6; ++k) {
    const Real angle = k * std::numbers::pi / 3;
    corners.push_back({0.4 * std::cos(angle), 0.4 * std::sin(angle), 0.1});
  }
  for (const Real tolerance : {1e-3, 1e-6, 1e-9}) {
    World world(awake());
    addPlane(world, 10, 0);
    BodyDescription top;
    top.shapes = {made(hullOfPoints(corners), 10, 0)};
    top.mass = MassProperties{
        .volume = 1, .mass = 1, .inertia = Vector3(across, across, about).asDiagonal()};
    top.position = l * axis(0);
    top.orientation = lies(0);
    top.angularVelocity = Vector3(0, 0, rate) + own * axis(0);
    top.velocity = cross(top.angularVelocity, top.position);
    const BodyId body = world.add(top);
    world.advance(1, tolerance);
    INFO("tolerance " << tolerance);
    CHECK((world.position(body) - l * axis(1)).norm() < 3 * tolerance);
    const Quaternion q = world.orientation(body), p = lies(1);
    const Quaternion turn = hamiltonProduct(q, conjugate(p));
    CHECK(2 * Vector3(turn.x, turn.y, turn.z).norm() < 3 * tolerance);
  }
}

TEST_CASE("a fast ball enters a quiet stack") {
  World world(awake());
  addPlane(world, 0, 0);
  std::vector<BodyId> boxes;
  for (int i = 0; i < 5; ++i) {
    boxes.push_back(
        addBox(world, Vector3::Constant(0.5), {.mass = 3, .position = {0, 0, 0.5 + i}}));
  }
  // It hits the lowest box after 2 s, in the middle, and pushes it out of the stack.
  const BodyId ball = addBall(world, 0.5, {.position = {-41, 0, 0.5}, .velocity = {20, 0, 0}});
  const world::Snapshot start = world.save();
  world.advance(1.9, 1e-9);
  for (int i = 0; i < 5; ++i) {
    const Vector3 centre = world.position(boxes[static_cast<std::size_t>(i)]);
    CHECK((centre - Vector3(0, 0, 0.5 + i)).norm() < 1e-9);
  }
  world.restore(start);
  world.advance(2.05, 1e-9);
  REQUIRE(!world.events().impacts.empty());
  const world::ImpactEvent& first = world.events().impacts[0];
  CHECK_THAT(first.time, WithinAbs(2, 1e-9));
  CHECK_THAT(first.approach, WithinAbs(20, 1e-9));
  // Masses of 1 and 3 kg go on together, and what lay above comes straight down.
  CHECK_THAT(world.velocity(ball).x(), WithinAbs(5, 1e-9));
  CHECK_THAT(world.position(boxes[0]).x(), WithinAbs(5 * 0.05, 3e-9));
  CHECK_THAT(world.position(boxes[4]).x(), WithinAbs(0, 3e-9));
  CHECK_THAT(world.momentum().x(), WithinAbs(20, 1e-9));
}

TEST_CASE("advance goes on from a snapshot bit by bit, and comes to the same bits again") {
  World world = tippingBox();
  world.advance(0.1, 1e-6);
  const world::Snapshot kept = world.save();
  world.advance(0.2, 1e-6);
  const std::uint64_t after = world.hash();
  world.restore(kept);
  world.advance(0.2, 1e-6);
  CHECK(world.hash() == after);
  World again = tippingBox();
  again.restore(kept);
  again.advance(0.2, 1e-6);
  CHECK(again.hash() == after);
}

TEST_CASE("steps and advances may take turns") {
  World world(awake());
  addPlane(world, 0, 0.8);
  const BodyId ball = addBall(world, 0.5, {.position = {0, 0, 5.5}, .restitution = 0.8});
  Real time = 0;
  for (int k = 0; k < 30; ++k) {
    world.step(kStep);
    world.advance(0.1, 1e-6);
    time += kStep + 0.1;
    const BouncingBall exact = bounceBall({5, 0}, {0.8, kGravity}, time);
    CHECK_THAT(world.position(ball).z() - 0.5, WithinAbs(exact.height, 1e-10));
  }
}
