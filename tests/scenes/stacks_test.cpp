// Does what should stand stand, and fall what should fall? Does anything but statics decide?

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "scenes/engine_carom.hpp"
#include "scenes/exact.hpp"
#include "scenes/families.hpp"
#include "scenes/run_scene.hpp"
#include "support/cases.hpp"
#include "support/catch.hpp"

using carom::Real;
using carom::Vector3;
using carom::world::World;
using carom::world::WorldSettings;
using carom_test::number;
using carom_test::readCase;
using carom_test::WithinAbs;
using carom_test::WithinRel;
namespace scenes = carom::scenes;

namespace {

constexpr Real kStep = 1.0 / 60;

using Figures = std::map<std::string, Real>;

Figures figuresOf(const scenes::Scene& scene, const WorldSettings& settings = {}) {
  Figures all;
  const auto kind = scenes::caromWith("carom", "", settings);
  const scenes::Run run = scenes::runScene(kind, scene, kStep);
  CHECK(run.finite);
  for (const scenes::Figure& figure : run.figures) all[figure.name] = figure.value;
  return all;
}

// Nothing is left out of a step.
WorldSettings skippingNothing() {
  WorldSettings settings;
  settings.sleeping = settings.keepStill = false;
  return settings;
}

// A scene in a world, for what a judge of poses cannot see.
struct Running {
  World world;
  std::vector<carom::world::BodyId> ids;

  explicit Running(const scenes::Scene& scene, const WorldSettings& settings = {})
      : world(scenes::settingsFor(scene, settings)), ids(scenes::addScene(scene, world)) {}

  void run(int steps) {
    for (int k = 0; k < steps; ++k) world.step(kStep);
  }

  // The force along the normal between two bodies of the scene [N].
  Real between(std::size_t a, std::size_t b) const {
    Real force = 0;
    for (const auto& pair : world.touching()) {
      const bool isIt = (pair.bodyA == ids[a] && pair.bodyB == ids[b]) ||
                        (pair.bodyA == ids[b] && pair.bodyB == ids[a]);
      if (isIt) force += pair.normalForce;
    }
    return force;
  }
};

}  // namespace

TEST_CASE("the judge of what stands sees the corner that moves most, in the depth of its pose") {
  const scenes::Scene scene = scenes::smallPyramidScene();
  const auto judge = scene.judge(scene);
  std::vector<scenes::State> bodies = scenes::startOf(scene);
  const auto seen = [&] {
    Figures all;
    judge->see(1, bodies);
    for (const scenes::Figure& figure : judge->figures()) all[figure.name] = figure.value;
    return all;
  };
  CHECK(seen()["moves [m]"] == 0);
  bodies[3].position.y() += 0.001;
  CHECK_THAT(seen()["moves [m]"], WithinAbs(0.001, 1e-15));
  // A turn about the vertical axis moves corners by their distance from it.
  bodies[3] = scene.bodies[3].start;
  bodies[3].orientation = {std::cos(0.05), 0, 0, std::sin(0.05)};
  Figures turned = seen();
  CHECK_THAT(turned["moved at the end [m]"], WithinAbs(std::sqrt(2.0) * std::sin(0.05), 1e-15));
  CHECK(turned["stands [1]"] == 1);
  bodies[15].position.z() -= 0.25;
  Figures fallen = seen();
  CHECK(fallen["stands [1]"] == 0);
  CHECK_THAT(fallen["deepest [m]"], WithinAbs(0.25, 1e-12));
}

TEST_CASE("ten cubes stand for a thousand seconds, and for a hundred if every step is made (S1)") {
  scenes::Scene scene = scenes::restingStackScene();
  Figures stood = figuresOf(scene);
  CHECK(stood["moves [m]"] <= 1e-9);
  CHECK(stood["deepest [m]"] <= 1e-9);
  scene.duration = 100;
  Figures made = figuresOf(scene, skippingNothing());
  CHECK(made["moves [m]"] <= 1e-9);
  CHECK(made["deepest [m]"] <= 1e-9);
}

TEST_CASE("every contact of the stack carries what is above it (S1)") {
  const auto S1 = readCase("scenes", "S1");
  Running stack(scenes::restingStackScene());
  stack.run(60);
  CHECK_THAT(stack.between(0, 1), WithinRel(number(S1["ground"]), 1e-8));
  CHECK_THAT(stack.between(9, 10), WithinRel(number(S1["top"]), 1e-8));
}

TEST_CASE("a box carries one that is up to a million times heavier (S4)") {
  for (const Real ratio : {10.0, 1000.0, 1e6}) {
    INFO("ratio " << ratio);
    const scenes::Scene scene = scenes::heavyOnLightScene("S4", ratio);
    Figures stood = figuresOf(scene);
    // Roundings of a load of a million boxes move the light one.
    const Real least = ratio > 1e5 ? 1e-8 : 1e-9;
    CHECK(stood["moves [m]"] <= least);
    CHECK(stood["deepest [m]"] <= least);
    Running pile(scene);
    pile.run(60);
    CHECK_THAT(pile.between(0, 1), WithinRel((ratio + 1) * 9.81, 1e-8));
    CHECK_THAT(pile.between(1, 2), WithinRel(ratio * 9.81, 1e-8));
    if (ratio != 1000) continue;
    const auto S4 = readCase("scenes", "S4");
    CHECK_THAT(pile.between(0, 1), WithinRel(number(S4["ground"]), 1e-8));
    CHECK_THAT(pile.between(1, 2), WithinRel(number(S4["between"]), 1e-8));
  }
}

TEST_CASE("a push from the side still moves what stands for ever") {
  for (const scenes::Scene& scene :
       {scenes::restingStackScene(), scenes::heavyOnLightScene("S4", 1000)}) {
    INFO(scene.name);
    Running pile(scene);
    pile.run(120);
    const auto top = pile.ids.back();
    const Vector3 before = pile.world.centre(top);
    // A metre per second, of which friction takes its part.
    pile.world.push(top, {scene.bodies.back().mass, 0, 0}, before);
    pile.run(30);
    CHECK(pile.world.centre(top).x() > before.x() + 0.05);
  }
}

TEST_CASE("a card house stands a millionth above the friction it needs, and slides below (S5)") {
  Figures stands = figuresOf(scenes::cardHouseScene("S5", 1e-6));
  CHECK(stands["moves [m]"] <= 1e-9);
  Figures slides = figuresOf(scenes::cardHouseScene("S5", -1e-3));
  CHECK(slides["stands [1]"] == 0);
}

TEST_CASE("arches stand and fall two per cent from where statics says, however rough (S6)") {
  for (const int stones : {8, 12, 20}) {
    for (const Real friction : {0.7, 4.0}) {
      INFO(stones << " stones, friction " << friction);
      scenes::Scene thick = scenes::archScene("S6", stones, 1.02, friction);
      scenes::Scene thin = scenes::archScene("S6", stones, 0.98, friction);
      thin.duration = 0.8;  // which is enough for a crown to come down
      thick.duration = stones == 12 && friction == 0.7 ? 60 : 2;
      CHECK(figuresOf(thick)["moves [m]"] < 1e-9);
      // Twenty hinging stones take long.
      if (stones < 20) CHECK(figuresOf(thin)["stands [1]"] == 0);
    }
  }
}

TEST_CASE("an arch of rough stones stands wherever it is, and its joints are found at once (S6)") {
  // Places round the corners of the stones differently: near a limit a solver may wander.
  for (const Real place : {-3.9, -1.3, 1.3, 3.9}) {
    INFO("at " << place << " m");
    scenes::Scene scene = scenes::archScene("S6", 12, 1.1, 4);
    for (scenes::Body& body : scene.bodies) {
      if (body.moves) body.start.position.x() += place;
    }
    Running arch(scene);
    arch.world.step(kStep);
    CHECK(arch.world.counters().islandsDirect == 1);
    CHECK(arch.world.counters().factorisations < 50);
    arch.run(300);
    for (std::size_t i = 1; i < arch.ids.size(); ++i) {
      CHECK((arch.world.centre(arch.ids[i]) - scene.bodies[i].start.position).norm() < 1e-12);
    }
  }
}

TEST_CASE("a pyramid of fifteen boxes stands a hundred seconds and weighs what it weighs (S11)") {
  const scenes::Scene scene = scenes::smallPyramidScene();
  Figures stood = figuresOf(scene);
  CHECK(stood["moves [m]"] <= 1e-9);
  Running pyramid(scene);
  pyramid.run(120);
  Real sum = 0;
  for (std::size_t i = 1; i <= 5; ++i) sum += pyramid.between(0, i);
  CHECK_THAT(sum, WithinAbs(number(readCase("scenes", "S11")["ground"]), 1e-9));
  // It is the same from both sides, and so are the forces, though not by any law.
  for (std::size_t i = 1; i <= 5; ++i) {
    CHECK_THAT(pyramid.between(0, i), WithinAbs(pyramid.between(0, 6 - i), 1e-9));
  }
}
