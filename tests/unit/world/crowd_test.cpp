// A long step of a crowd in flight is gone in parts, and everybody meets whom he would have met.

#include "carom/world/crowd.hpp"
#include "carom/core/random.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"

using namespace carom_test;

namespace {

constexpr Real kRadius = 0.1, kHalf = 1.5;

struct Gas {
  explicit Gas(bool divided)
      : world([&] {
          WorldSettings settings = weightless();
          settings.divideCrowds = divided;
          return settings;
        }()) {}
  World world;
  std::vector<BodyId> balls;
};

// Elastic balls on a grid in a closed room, with speeds of a few metres a second.
Gas gas(int edge, Real speed = 4, bool divided = true) {
  Gas gas(divided);
  for (int k = 0; k < 3; ++k) {
    const Vector3 normal = Vector3::Unit(k);
    addPlane(gas.world, 0, 1, normal, -kHalf * normal);
    addPlane(gas.world, 0, 1, -normal, kHalf * normal);
  }
  Random random(7);
  for (int i = 0; i < edge * edge * edge; ++i) {
    const Vector3 cell(i % edge, i / edge % edge, i / (edge * edge));
    Thing ball;
    ball.position =
        (2 * cell + Vector3::Ones() - Vector3::Constant(edge)) * (kHalf - kRadius) / edge;
    ball.velocity = random.vector(speed);
    ball.restitution = 1;
    gas.balls.push_back(addBall(gas.world, kRadius, ball));
  }
  return gas;
}

// By how much balls overlap each other or a wall at most.
Real deepest(const Gas& gas) {
  std::vector<Vector3> places;
  for (const BodyId ball : gas.balls) places.push_back(gas.world.position(ball));
  Real depth = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    depth = std::max(depth, places[i].cwiseAbs().maxCoeff() + kRadius - kHalf);
    for (std::size_t j = 0; j < i; ++j) {
      depth = std::max(depth, 2 * kRadius - (places[i] - places[j]).norm());
    }
  }
  return depth;
}

}  // namespace

TEST_CASE("a long step of a gas is gone in parts, and nobody passes through another") {
  Gas all = gas(6);
  for (int step = 0; step < 8; ++step) {
    all.world.step(0.25);
    REQUIRE(all.world.counters().parts >= 4);
    REQUIRE(deepest(all) < 1e-9);
  }
  CHECK_THAT(all.world.time(), WithinAbs(2, 1e-15));
}

TEST_CASE("one long step of a gas ends where many short ones do") {
  Gas once = gas(6), often = gas(6);
  once.world.step(0.125);
  REQUIRE(once.world.counters().parts >= 2);
  std::size_t impacts = 0;
  for (int step = 0; step < 32; ++step) {
    often.world.step(0.125 / 32);
    REQUIRE(often.world.counters().parts == 1);
    impacts += often.world.events().impacts.size();
  }
  CHECK(impacts > 50);
  CHECK(once.world.events().impacts.size() == impacts);
  for (const BodyId ball : once.balls) {
    const Vector3 apart = once.world.position(ball) - often.world.position(ball);
    CHECK_THAT(apart.norm(), WithinAbs(0, 1e-9));
  }
}

TEST_CASE("impacts of all parts come in the order of their times within the step") {
  Gas all = gas(6);
  all.world.step(0.25);
  REQUIRE(all.world.counters().parts >= 4);
  Real before = 0;
  for (const auto& impact : all.world.events().impacts) {
    CHECK(impact.time >= before);
    before = impact.time;
  }
  CHECK(before > 0.2);
  CHECK(before <= 0.25);
}

TEST_CASE("few bodies, a crowd that hardly moves, and one that is not divided go a step in one") {
  Gas few = gas(3), slow = gas(6, 0.05), whole = gas(6, 4, false);
  for (Gas* all : {&few, &slow, &whole}) {
    all->world.step(0.25);
    CHECK(all->world.counters().parts == 1);
  }
}
