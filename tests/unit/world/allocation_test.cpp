// A step takes no memory once a scene has come to its largest size.

#include <cmath>

#include "carom/core/random.hpp"
#include "carom/precision/exact_determinant.hpp"
#include "carom/world/list_pool.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"
#include "support/counted_memory.hpp"
#include "support/random_shapes.hpp"

namespace {

// Solids that tumble in a room, hit each other and bounce.
void addTumbling(carom_test::World& world, bool hulls) {
  using namespace carom_test;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Real side : {-1.0, 1.0}) {
      Vector3 out = Vector3::Zero();
      out[axis] = side;
      carom_test::addPlane(world, 0.5, 0.9, -out, 1.2 * out);
    }
  }
  Random random(3);
  for (int i = 0; i < 12; ++i) {
    const Vector3 place(0.8 * (i % 3 - 1), 0.8 * (i / 3 % 2) - 0.4, 0.8 * (i / 6) - 0.4);
    Thing thing{.position = place, .friction = 0.5, .restitution = 0.9};
    thing.velocity = random.vector(4);
    thing.angularVelocity = random.vector(4);
    if (hulls) {
      add(world, randomHull(random, 0.3), 0.2, thing);
    } else {
      addBox(world, {0.2, 0.15, 0.1}, thing);
    }
  }
}

}  // namespace

TEST_CASE("a step of a scene at rest takes no memory, although nothing sleeps") {
  using namespace carom_test;
  using carom_test::addPlane;
  World world(awake());
  addPlane(world, 0.5, 0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        addBox(world, {0.25, 0.2, 0.15},
               {.position = {i * 0.8, j * 0.8, 0.15 + 0.3 * k}, .friction = 0.5});
      }
    }
  }
  for (int i = 0; i < 20; ++i) {
    addBall(world, 0.1, {.position = {4 + 0.3 * (i % 5), 0.3 * (i / 5), 0.3}, .friction = 0.3});
  }
  run(world, 60);
  const std::size_t before = allocations;
  run(world, 60);
  CHECK(allocations == before);
}

TEST_CASE("a world that advances takes no memory once it has seen what happens in it") {
  using namespace carom_test;
  using carom_test::addPlane;
  World world(awake());
  addPlane(world, 0.3, 0);
  // Balls that bounce for ever, one that slides and rolls, and boxes that rest and spin.
  for (int i = 0; i < 5; ++i) {
    addBall(world, 0.3, {.position = {2.0 * i - 4, 0, 0.5 + 0.2 * i}, .restitution = 1});
  }
  addBall(world, 0.5, {.position = {0, 3, 0.5}, .velocity = {5, 0, 0}, .friction = 0.3});
  for (int k = 0; k < 3; ++k) {
    addBox(world, {0.25, 0.2, 0.15}, {.position = {0, 6, 0.15 + 0.3 * k}, .friction = 0.5});
  }
  addBox(world, {0.3, 0.2, 0.1},
         {.position = {0, 9, 0.1}, .angularVelocity = {0, 0, 40}, .friction = 0.1});
  for (int k = 0; k < 20; ++k) world.advance(0.1, 1e-6);
  const std::size_t before = allocations;
  for (int k = 0; k < 10; ++k) world.advance(0.1, 1e-6);
  CHECK(allocations == before);
}

TEST_CASE("impacts of boxes and of polyhedra take no memory after the first seconds") {
  using namespace carom_test;
  const bool hulls = GENERATE(false, true);
  World world(awake());
  addTumbling(world, hulls);
  run(world, 120);
  const std::size_t before = allocations;
  long impacts = 0;
  for (int step = 0; step < 120; ++step) {
    world.step(kStep);
    impacts += world.counters().impacts;
  }
  CHECK(allocations == before);
  CHECK(impacts > 100);
}

TEST_CASE("a heap that still falls takes no memory after its first second") {
  using namespace carom_test;
  using carom_test::addPlane;
  World world(awake());
  addPlane(world, 0.5, 0);
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Vector3 place(1.1 * (i % 5), 1.1 * (i / 5 % 5), 0.6 + 1.3 * (i / 25));
    addBox(world, Vector3::Constant(0.5),
           {.position = place + random.vector(0.1),
            .angularVelocity = random.vector(1),
            .friction = 0.5});
  }
  run(world, 60);
  // Exact sums keep memory of their own in each thread, taken when they are first needed.
  orientation(Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), Vector3(1, 1, 0));
  const std::size_t before = allocations;
  std::size_t begun = 0;
  for (int step = 0; step < 300; ++step) {
    world.step(kStep);
    begun += world.events().begun.size();
  }
  CHECK(allocations == before);
  CHECK(begun > 500);
}

TEST_CASE("balls that collide beside a crowd take no memory after the first second") {
  using namespace carom_test;
  const bool moves = GENERATE(false, true);
  World world;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Real side : {-1.0, 1.0}) {
      // Slabs around a room: the crowd stands outside, on one of them.
      Vector3 half = Vector3::Constant(axis == 2 ? 40.0 : 3.0);
      half[axis] = 0.5;
      BodyDescription wall;
      wall.kind = BodyKind::immovable;
      wall.position[axis] = 2.5 * side;
      wall.shapes = {made(Box{half}, 0.5, 1)};
      world.add(wall);
    }
  }
  Random random(10);
  for (int i = 0; i < 10; ++i) {
    addBall(world, 0.25,
            {.position = {i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0},
             .velocity = random.vector(3),
             .restitution = 1});
  }
  for (int i = 0; i < 100; ++i) {
    const Vector3 place(8.0 + i % 10, i / 10, -1.75);
    if (moves) {
      addBox(world, Vector3::Constant(0.25), {.position = place, .friction = 0.5});
      continue;
    }
    BodyDescription box;
    box.kind = BodyKind::immovable;
    box.position = place;
    box.shapes = {made(Box{Vector3::Constant(0.25)}, 0.5, 0)};
    world.add(box);
  }
  run(world, 60);
  CHECK(world.counters().bodiesAsleep == (moves ? 100 : 0));
  const std::size_t before = allocations;
  long impacts = 0;
  for (int step = 0; step < 600; ++step) {
    world.step(kStep);
    impacts += world.counters().impacts;
  }
  CHECK(allocations == before);
  CHECK(impacts > 100);
}

TEST_CASE("lists that come and go take memory once") {
  carom::world::ListPool pool;
  const auto split = [&] {
    // One long list, then many short ones, as when an island comes apart.
    carom::world::ListPool::List whole;
    std::vector<carom::world::ListPool::List> parts(20);
    for (int i = 0; i < 200; ++i) pool.append(whole, i);
    bool same = whole.size() == 200;
    for (int i = 0; i < 200; ++i) pool.append(parts[static_cast<std::size_t>(i % 20)], whole[i]);
    for (int i = 0; i < 200; ++i)
      same = same && parts[static_cast<std::size_t>(i % 20)][i / 20] == i;
    pool.giveBack(whole);
    for (auto& part : parts) pool.giveBack(part);
    return same && whole.empty();
  };
  CHECK(split());
  const std::size_t before = carom_test::allocations;
  const bool again = split();
  const std::size_t asked = carom_test::allocations - before;
  CHECK(again);
  CHECK(asked == 1);  // the list of lists
}

TEST_CASE("an island that is solved directly takes no memory") {
  using namespace carom_test;
  using carom_test::addPlane;
  WorldSettings settings = awake();
  settings.keepStill = false;
  World world(settings);
  addPlane(world, 0.5, 0);
  // Light ones under heavy ones: sweeps gain little.
  for (int i = 0; i < 8; ++i) {
    addBox(world, Vector3::Constant(0.5),
           {.mass = std::pow(3.0, i), .position = {0.02 * i, 0, 0.5 + i}, .friction = 0.5});
  }
  const auto push = [&] { world.push(world.bodies()[1], {0.01, 0, 0}, {0, 0, 0.5}); };
  long direct = 0;
  for (int step = 0; step < 60; ++step) {
    push();
    world.step(kStep);
  }
  std::size_t asked = 0;
  for (int step = 0; step < 60; ++step) {
    push();
    const std::size_t before = allocations;
    world.step(kStep);
    asked += allocations - before;
    direct += world.counters().islandsDirect;
  }
  CHECK(asked == 0);
  CHECK(direct > 0);
}
