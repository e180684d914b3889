// Is what nothing can change left alone, and can nobody tell?

#include <functional>
#include <vector>

#include "scene_parts.hpp"
#include "support/catch.hpp"

using namespace carom_test;
using carom::world::BodyDescription;
using carom::world::BodyKind;

namespace {

// Two worlds of the same bodies, one of which steps everything.
struct Twins {
  World quick{awake()};
  World plain{plainSettings()};

  static WorldSettings plainSettings() {
    WorldSettings settings = awake();
    settings.keepStill = false;
    return settings;
  }

  // What is done to one is done to the other.
  void both(const std::function<void(World&)>& change) {
    change(quick);
    change(plain);
  }

  // Steps both; they must agree in every bit after each step.
  void agreeFor(int steps, Real dt = kStep) {
    for (int k = 0; k < steps; ++k) {
      quick.step(dt);
      plain.step(dt);
      REQUIRE(quick.hash() == plain.hash());
      REQUIRE(quick.events().impacts.size() == plain.events().impacts.size());
      REQUIRE(quick.events().begun.size() == plain.events().begun.size());
      REQUIRE(quick.events().ended.size() == plain.events().ended.size());
    }
  }
};

const Vector3 kHalf = Vector3::Constant(0.5);

// Boxes that stand apart on a floor, at rest.
std::vector<BodyId> addField(World& world, int count) {
  std::vector<BodyId> all{addPlane(world, 0.5, 0)};
  for (int i = 0; i < count; ++i) {
    all.push_back(
        addBox(world, kHalf, {.mass = 1000, .position = {2.0 * i, 0, 0.5}, .friction = 0.5}));
  }
  return all;
}

}  // namespace

TEST_CASE("boxes at rest are looked at once and then not stepped") {
  World world(awake());
  addField(world, 20);
  run(world, 5);
  CHECK(world.counters().islandsStill == 20);
  CHECK(world.counters().pairsKept == 20);
  CHECK(world.counters().manifoldsMade == 0);
  CHECK(world.counters().normalRows == 0);
  CHECK(world.counters().rowsSolved == 0);
  CHECK(world.counters().bodiesAwake == 20);
  CHECK(world.touching().size() == 20);
}

TEST_CASE("what is pushed, hit or robbed of its floor is stepped again, to the same last bit") {
  Twins twins;
  std::vector<BodyId> ids;
  twins.both([&](World& world) { ids = addField(world, 4); });
  twins.agreeFor(10);
  REQUIRE(twins.quick.counters().islandsStill == 4);

  SECTION("pushed") {
    twins.both([&](World& world) { world.push(ids[2], {500, 100, 0}, {2, 0, 0.8}); });
    twins.agreeFor(90);
    CHECK(twins.quick.counters().islandsStill >= 3);
  }
  SECTION("hit by a ball that was not there") {
    twins.both([&](World& world) {
      addBall(world, 0.25, {.mass = 200, .position = {-8, 0, 0.6}, .velocity = {20, 0, 0}});
    });
    twins.agreeFor(90);
    CHECK(twins.quick.position(ids[1]) != Vector3(0, 0, 0.5));
  }
  SECTION("a box is laid upon another") {
    twins.both([&](World& world) {
      addBox(world, kHalf, {.mass = 500, .position = {2, 0, 1.6}, .friction = 0.5});
    });
    twins.agreeFor(90);
  }
  SECTION("the floor is taken away") {
    twins.both([&](World& world) { world.remove(ids[0]); });
    twins.agreeFor(20);
    CHECK(twins.quick.counters().islandsStill == 0);
    CHECK(twins.quick.position(ids[1]).z() < 0.4);
  }
  SECTION("the floor is lowered") {
    twins.both([&](World& world) { world.place(ids[0], {0, 0, -0.2}, {}); });
    twins.agreeFor(60);
    CHECK(twins.quick.position(ids[1]).z() < 0.31);
  }
  SECTION("a force acts") {
    twins.both([&](World& world) { world.setForce(ids[3], {6000, 0, 0}, Vector3::Zero()); });
    twins.agreeFor(60);
    CHECK(twins.quick.velocity(ids[3]).x() > 0.5);
  }
  SECTION("steps become longer") {
    twins.agreeFor(20, 1.0 / 30);
  }
  SECTION("weight turns round") {
    for (World* world : {&twins.quick, &twins.plain}) {
      WorldSettings settings = world->settings();
      settings.gravity = {0, 0, 9.81};
      world->change(settings);
    }
    twins.agreeFor(30);
    CHECK(twins.quick.position(ids[1]).z() > 0.6);
  }
  SECTION("placed elsewhere, above another") {
    twins.both([&](World& world) { world.place(ids[4], {2, 0, 1.7}, {}); });
    twins.agreeFor(90);
    CHECK(twins.quick.position(ids[4]).z() < 1.51);
  }
}

TEST_CASE("what stands on ground that moves is stepped") {
  Twins twins;
  BodyId belt;
  twins.both([&](World& world) {
    BodyDescription ground;
    ground.kind = BodyKind::kinematic;
    ground.position = {0, 0, -0.5};
    ground.shapes = {made(carom::Box{{50, 5, 0.5}}, 0.5, 0)};
    belt = world.add(ground);
    addBox(world, kHalf, {.mass = 10, .position = {0, 0, 0.5}, .friction = 0.5});
  });
  twins.agreeFor(10);
  twins.both([&](World& world) { world.setVelocity(belt, {0.5, 0, 0}, Vector3::Zero()); });
  twins.agreeFor(30);
  twins.both([&](World& world) { world.setVelocity(belt, Vector3::Zero(), Vector3::Zero()); });
  twins.agreeFor(30);
}

TEST_CASE("a stack and balls that roll and bounce are the same with and without") {
  Twins twins;
  twins.both([&](World& world) {
    addPlane(world, 0.5, 0);
    for (int i = 0; i < 5; ++i) {
      addBox(world, kHalf, {.mass = 1000, .position = {0, 0, i + 0.5}, .friction = 0.5});
    }
    addBall(world, 0.3,
            {.mass = 1, .position = {3, 0, 0.3}, .velocity = {0.2, 0, 0}, .friction = 0.5});
    addBall(world, 0.3, {.mass = 1, .position = {5, 0, 1}, .friction = 0.5, .restitution = 0.5});
  });
  twins.agreeFor(240);
}
