// Large islands take soft steps: in lanes, with threads, and to the same bits.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "carom/core/errors.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"
#include "support/random_shapes.hpp"

using namespace carom_test;

namespace {

constexpr Real kHalf = 0.5;

// A wall of cubes in the shape of a triangle.
std::vector<BodyId> addPyramid(World& world, int base) {
  addPlane(world, kHalf, 0);
  std::vector<BodyId> cubes;
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      Thing thing;
      thing.mass = 1000;
      thing.position = {1.1 * (i - 0.5 * (base - row - 1)), 0, row + kHalf};
      thing.friction = kHalf;
      cubes.push_back(addBox(world, Vector3::Constant(kHalf), thing));
    }
  }
  return cubes;
}

WorldSettings piles(int threads = 1) {
  WorldSettings settings = awake();
  settings.pileContacts = 40;
  settings.threads = threads;
  return settings;
}

std::uint64_t hashAfter(const WorldSettings& settings, int base, int steps) {
  World world(settings);
  addPyramid(world, base);
  for (int i = 0; i < steps; ++i) world.step(kStep);
  return world.hash();
}

}  // namespace

TEST_CASE("a wall of cubes stands where it was put") {
  World world(piles());
  const std::vector<BodyId> cubes = addPyramid(world, 8);
  std::vector<Vector3> start;
  for (const BodyId cube : cubes) start.push_back(world.centre(cube));
  for (int i = 0; i < 300; ++i) world.step(kStep);
  CHECK(world.counters().pileBodies == 36);
  CHECK(world.counters().pileContacts >= 64);
  CHECK(world.counters().pileColors >= 3);
  Real farthest = 0;
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    farthest = std::max(farthest, (world.centre(cubes[i]) - start[i]).norm());
  }
  // What is left alone of an overlap, eight times over.
  CHECK(farthest < 8e-3);
}

TEST_CASE("a pile comes to the same bits with any number of threads, and again") {
  const std::uint64_t one = hashAfter(piles(1), 12, 90);
  for (const int threads : {1, 2, 3, 5}) CHECK(hashAfter(piles(threads), 12, 90) == one);
}

// What falls beside what sleeps and what stands joins piles, wakes and gives room.
TEST_CASE("a heap that falls onto sleepers comes to the same bits with any number of threads") {
  const auto hashWith = [](int threads) {
    WorldSettings settings;
    settings.pileContacts = 40;
    settings.threads = threads;
    World world(settings);
    addPyramid(world, 6);
    run(world, 90);
    Random random(3);
    for (int i = 0; i < 140; ++i) {
      const Vector3 place = random.vector(4) + Vector3(0, 0, 6);
      const Vector3 velocity = random.vector(3);
      const Thing thing{.position = place, .velocity = velocity, .friction = 0.5};
      if (i % 2 == 0) {
        addBall(world, 0.4, thing);
      } else {
        addBox(world, {0.5, 0.4, 0.3}, thing);
      }
    }
    run(world, 50);
    return world.hash();
  };
  const std::uint64_t one = hashWith(1);
  for (const int threads : {2, 3}) CHECK(hashWith(threads) == one);
}

TEST_CASE("a pile goes on from a snapshot as it went on from there") {
  World world(piles(2));
  addPyramid(world, 8);
  for (int i = 0; i < 30; ++i) world.step(kStep);
  const carom::world::Snapshot snapshot = world.save();
  for (int i = 0; i < 30; ++i) world.step(kStep);
  const std::uint64_t hash = world.hash();
  world.restore(snapshot);
  for (int i = 0; i < 30; ++i) world.step(kStep);
  CHECK(world.hash() == hash);
}

TEST_CASE("piles are stepped together, and each goes as if it were alone to the last bit") {
  // They tumble over corners and edges onto faces and off them again, so that the contacts of a
  // block have one point to four.
  constexpr int kPairs = 20;
  const auto add = [](World& world, int pair) {
    Random random(static_cast<std::uint64_t>(pair));
    std::vector<BodyId> boxes;
    for (int i = 0; i < 2; ++i) {
      Thing thing{.position = {0.3 * i, 8.0 * pair, 1 + 1.1 * i}, .friction = 0.5};
      thing.angularVelocity = random.vector(3);
      thing.velocity = random.vector(1);
      boxes.push_back(addBox(world, {0.5, 0.4, 0.3}, thing));
    }
    return boxes;
  };
  WorldSettings settings = awake();
  settings.pileContacts = settings.pileBodies = 0;
  World together(settings);
  addPlane(together, 0.5, 0);
  std::vector<std::vector<BodyId>> all;
  for (int pair = 0; pair < kPairs; ++pair) all.push_back(add(together, pair));
  std::int64_t most = 0;
  for (int i = 0; i < 120; ++i) {
    together.step(kStep);
    most = std::max(most, together.counters().pileBodies);
  }
  CHECK(most > kPairs);
  for (int pair = 0; pair < kPairs; ++pair) {
    World alone(settings);
    addPlane(alone, 0.5, 0);
    const std::vector<BodyId> own = add(alone, pair);
    run(alone, 120);
    for (std::size_t i = 0; i < own.size(); ++i) {
      INFO("pair " << pair << ", box " << i);
      CHECK(alone.centre(own[i]) == together.centre(all[static_cast<std::size_t>(pair)][i]));
      CHECK(alone.angularVelocity(own[i]) ==
            together.angularVelocity(all[static_cast<std::size_t>(pair)][i]));
    }
  }
}

TEST_CASE("small islands are no piles") {
  World world(awake());
  addPyramid(world, 3);
  for (int i = 0; i < 10; ++i) world.step(kStep);
  CHECK(world.counters().pileBodies == 0);
}

TEST_CASE("settings of piles that mean nothing are refused") {
  WorldSettings settings;
  settings.threads = 0;
  CHECK_THROWS_AS(World(settings), InvalidInput);
  settings.threads = 1;
  settings.shortSteps = 0;
  CHECK_THROWS_AS(World(settings), InvalidInput);
  settings.shortSteps = 1;
  settings.pileContacts = -1;
  CHECK_THROWS_AS(World(settings), InvalidInput);
  settings.pileContacts = 0;
  settings.pileBodies = -1;
  CHECK_THROWS_AS(World(settings), InvalidInput);
}
