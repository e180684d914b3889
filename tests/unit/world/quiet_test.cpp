// Bodies that nothing can touch in a step have no manifolds in it, and nobody else can tell.

#include "carom/world/quiet.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"

using namespace carom_test;

namespace {

// A column of cubes with gaps between, all falling at one speed over a floor.
World column(int count, Real gap, Real speed, Real height) {
  WorldSettings settings = awake();
  settings.pileBodies = settings.pileContacts = 0;
  World world(settings);
  BodyDescription floor;
  floor.kind = BodyKind::immovable;
  floor.shapes = {made(HalfSpace{Vector3::UnitZ(), 0}, 0.5, 0)};
  world.add(floor);
  for (int i = 0; i < count; ++i) {
    BodyDescription cube;
    cube.shapes = {made(Box{Vector3::Constant(0.5)}, 0.5, 0)};
    cube.position = {0, 0, height + 0.5 + i * (1 + gap)};
    cube.velocity = {0, 0, -speed};
    world.add(cube);
  }
  return world;
}

Real lowestGap(const World& world) {
  Real least = 1;
  const std::vector<BodyId> bodies = world.bodies();
  for (std::size_t i = 1; i + 1 < bodies.size(); ++i) {
    least = std::min(least, world.position(bodies[i + 1]).z() - world.position(bodies[i]).z() - 1);
  }
  return least;
}

}  // namespace

TEST_CASE("cubes that fall side by side want no manifolds, however fast they fall") {
  World world = column(20, 0.05, 30, 1000);
  world.step(kStep);
  world.step(kStep);
  // The way of a step is half a metre, ten times the gap.
  CHECK(world.counters().pairsAwake >= 19);
  CHECK(world.counters().manifoldsMade == 0);
  world.step(kStep);
  CHECK(world.counters().contactPoints == 0);
  CHECK_THAT(lowestGap(world), WithinAbs(0.05, 1e-12));
}

TEST_CASE("a column that comes to rest does so from its foot up") {
  // The foot lands in the third step; what it stops is met by as many as the rest of the step and
  // the gaps let through. Soft steps press the lower ones into each other by an eighth of an edge,
  // with or without the manifolds of those above.
  constexpr Real kPressed = 0.13;
  World world = column(20, 0.05, 12, 0.5);
  std::int64_t most = 0;
  for (int i = 0; i < 30; ++i) {
    world.step(kStep);
    const std::int64_t made = world.counters().manifoldsMade;
    if (i == 2) CHECK(made < 15);
    most = std::max(most, made);
    CHECK(lowestGap(world) > -kPressed);
  }
  CHECK(most >= 15);
}
