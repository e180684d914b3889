// What no step may give a body: a place behind a wall, or energy.

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/detection/convex_hull.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"

using namespace carom_test;

TEST_CASE("who strikes more often in a step than anybody follows stays between the walls") {
  WorldSettings settings = weightless();
  settings.eventsPerBody = 1;
  const int parts = GENERATE(1, 2);
  Real least = 1, most = 0;
  for (int k = 0; k < 60; ++k) {
    World world(settings);
    addPlane(world, 0, 0.5);
    addPlane(world, 0, 0.5, -Vector3::UnitZ(), {0, 0, 1});
    BodyDescription rod;
    rod.position = {0, 0, 0.5};
    rod.velocity = {0, 0, 20};
    rod.angularVelocity = {200.0 + 5 * k, 10, 10};
    for (int i = 0; i < parts; ++i) {
      rod.shapes.push_back(made(Box{{0.05, 0.49 / parts, 0.05}}, 0, 0.5));
      rod.shapes.back().pose.p_WB = {0, (2 * i + 1 - parts) * 0.49 / parts, 0};
    }
    const BodyId body = world.add(rod);
    for (int step = 0; step < 10; ++step) {
      world.step(kStep);
      least = std::min(least, world.centre(body).z());
      most = std::max(most, world.centre(body).z());
    }
  }
  CHECK(least > 0);
  CHECK(most < 1);
}

TEST_CASE("a body whose middle is outside of it may have a wall there") {
  World world(weightless());
  BodyDescription post;
  post.kind = BodyKind::immovable;
  post.shapes = {made(Box{{0.1, 1, 1}}, 0, 0)};
  world.add(post);
  // Two blocks to the left and to the right of it; their frames are where their body has its own.
  BodyDescription astride;
  astride.position = {0, 0, 2};
  astride.velocity = {0, 0, -10};
  for (const Real side : {-1.0, 1.0}) {
    std::vector<Vector3> corners = boxHull(Vector3::Constant(0.1)).vertices;
    for (Vector3& corner : corners) corner.x() += 0.25 * side;
    astride.shapes.push_back(made(hullOfPoints(corners), 0, 0));
  }
  const BodyId body = world.add(astride);
  run(world, 12);
  CHECK(std::abs(world.position(body).z()) < 1e-9);
}

TEST_CASE("what is lifted out of the floor pays with the speed at which it has come or goes") {
  // Found 0.05 m too late, it has fallen so much too far, and bounces as high as it has come from.
  World world(awake());
  addPlane(world, 0, 1);
  const BodyId box = addBox(world, {0.5, 0.5, 0.5},
                            {.position = {0, 0, 0.45}, .velocity = {1, 0, -2}, .restitution = 1});
  const Real energy = world.energy();
  for (int step = 0; step < 60; ++step) {
    world.step(kStep);
    CHECK(std::abs(world.energy() - energy) < 1e-9);
  }
  CHECK(std::abs(world.velocity(box).x() - 1) < 1e-12);
}

TEST_CASE("a deep overlap comes apart as fast whatever the step, and of what is small no faster") {
  const auto liftIn = [](Real size, Real depth, int steps) {
    World world(weightless());
    addPlane(world, 0, 0);
    const BodyId box = addBox(world, Vector3::Constant(size), {.position = {0, 0, size - depth}});
    const Real before = world.position(box).z();
    run(world, steps, 0.1 / steps);
    return (world.position(box).z() - before) / depth;
  };
  CHECK(std::abs(liftIn(0.5, 0.2, 6) / liftIn(0.5, 0.2, 24) - 1) < 0.1);
  CHECK(std::abs(liftIn(0.5, 0.2, 6) / liftIn(0.005, 0.002, 6) - 1) < 0.1);
}

TEST_CASE("rough boxes between walls gain nothing, by soft steps or where too much happens") {
  WorldSettings settings = weightless();
  if (GENERATE(false, true)) settings.pileContacts = 0;
  settings.eventsPerBody = 1;
  settings.iterations = 1;
  settings.rowBudget = 100;
  Real most = 0;
  for (int k = 0; k < 60; ++k) {
    World world(settings);
    addPlane(world, 2, 0.5);
    addPlane(world, 2, 0.5, -Vector3::UnitZ(), {0, 0, 1.3});
    for (int i = 0; i < 2; ++i) {
      const Vector3 spin(std::sin(k + i), std::cos(2 * k), std::sin(3 * k - i));
      addBox(world, {0.5, 0.3, 0.2},
             {.mass = 1 + 9.0 * i,
              .position = {0, 0, 0.3 + 0.6 * i},
              .velocity = {1, 0, 1 - 2.0 * i},
              .angularVelocity = 10 * spin,
              .friction = 2,
              .restitution = 0.5});
    }
    most = std::max(most, gainedBy(world, 60));
  }
  CHECK(most < 1e-5);
}

TEST_CASE("what lies deep in the ground gains no more in a step than it is lent, and comes out") {
  // Alone, sliding, and with a neighbour that rolls.
  const int kind = GENERATE(0, 1, 2);
  World world(awake());
  addPlane(world, 0, 0);
  const BodyId box =
      addBox(world, Vector3::Constant(0.5),
             {.position = {0, 0, 0.2}, .velocity = {kind == 1 ? 1.0 : 0.0, 0, 0}, .friction = 0});
  Real weights = world.mass(box) * kGravity;
  if (kind == 2) {
    const BodyId ball =
        addBall(world, 0.5, {.position = {1, 0, 0.5}, .velocity = {-1, 3, 0}, .friction = 0});
    weights += world.mass(ball) * kGravity;
  }
  const Real lent = weights * std::sqrt(0.75) / 200;
  Real most = 0;
  for (int step = 0; step < 240; ++step) {
    const Real before = world.energy();
    world.step(kStep);
    most = std::max(most, world.energy() - before);
  }
  CHECK(most < 1.001 * lent);
  CHECK(world.position(box).z() > 0.499);
}

TEST_CASE("bodies in flight that are pressed into each other pay, and keep their momentum") {
  World world(awake());
  std::vector<BodyId> boxes;
  for (const Real side : {-1.0, 1.0}) {
    boxes.push_back(addBox(world, Vector3::Constant(0.5),
                           {.mass = 2 + side,
                            .position = {0.4 * side, 0, 0},
                            .velocity = {0, 100, 0},
                            .angularVelocity = {10, 0, 0},
                            .friction = 0}));
  }
  const Vector3 momentum = 4 * Vector3(0, 100, 0);
  long kept = 0;
  for (int step = 1; step <= 10; ++step) {
    world.setForce(boxes[0], {1000, 0, 0}, Vector3::Zero());
    world.setForce(boxes[1], {-1000, 0, 0}, Vector3::Zero());
    world.step(kStep);
    kept += world.counters().energiesKept;
    Vector3 now = Vector3::Zero();
    for (const BodyId box : boxes) now += world.mass(box) * world.velocity(box);
    CHECK((now - momentum + 4 * step * kStep * kGravity * Vector3::UnitZ()).norm() < 1e-9);
  }
  CHECK(kept > 0);
}

TEST_CASE(
    "what tumbles past a wall pays for the errors of its turning with that, not with its way") {
  WorldSettings settings = weightless();
  settings.locateEvents = false;
  Real lost = 0, gained = 0;
  for (int k = 0; k < 20; ++k) {
    World world(settings);
    addPlane(world, 0, 0);
    const Vector3 spin(std::sin(k), std::cos(2 * k), std::sin(3 * k));
    const BodyId plate =
        addBox(world, {0.5, 0.3, 0.1},
               {.position = {0, 0, 0.7}, .velocity = {10, 0, 0}, .angularVelocity = 10 * spin});
    gained = std::max(gained, gainedBy(world, 60));
    lost = std::max(lost, std::abs(world.velocity(plate).x() - 10));
  }
  CHECK(lost == 0);
  CHECK(gained < 1e-6);
}
