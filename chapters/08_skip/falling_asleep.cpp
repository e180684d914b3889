// Who may sleep, and who only looks as if?
//
// A board stands on its edge, a millionth of a radian beyond its balance: for seconds it is slower
// than anything that rests. Beside it two towers of boxes settle. The world puts the towers to
// sleep and not the board, which falls. Then somebody pushes one of the towers.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/world/find_islands.hpp"
#include "carom/world/wake.hpp"
#include "carom/world/world.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;
using carom::world::BodyDescription;
using carom::world::BodyId;
using carom::world::World;

constexpr Real kStep = 1.0 / 60;
constexpr Real kHalf = 0.25;        // half the edge of a box [m]
const Vector3 kBoard(0.1, 0.3, 1);  // half its edges [m]

struct Actor {
  std::string name;
  BodyId id;
  Vector3 halfExtents;
  Real slowSince = 0, slowAt = 0, asleepAt = 0;  // [s]; 0: never
};

Actor addBox(World& world, const std::string& name, const Vector3& half, const Vector3& at,
             const carom::Quaternion& orientation = {}) {
  BodyDescription body;
  body.position = at;
  body.orientation = orientation;
  body.shapes = {{.shape = carom::makeBox(half)}};
  return {name, world.add(body), half};
}

Real speedOf(const World& world, const Actor& actor) {
  const BodyId id = actor.id;
  return world.velocity(id).norm() + actor.halfExtents.norm() * world.angularVelocity(id).norm();
}

// Each body has two looks; the one that is not meant waits outside of the picture.
carom::io::Frame frameOf(const World& world, const std::vector<Actor>& actors) {
  carom::io::Frame frame{.time = world.time()};
  for (const Actor& actor : actors) {
    const carom::io::Pose here{world.position(actor.id), world.orientation(actor.id)};
    const carom::io::Pose away{{0, 0, -40}};
    frame.poses.push_back(world.asleep(actor.id) ? away : here);
    frame.poses.push_back(world.asleep(actor.id) ? here : away);
  }
  frame.channels = {Real(world.counters().bodiesAwake)};
  return frame;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  World world;
  BodyDescription floor;
  floor.kind = carom::world::BodyKind::immovable;
  floor.shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero())}};
  world.add(floor);

  // The board turns about the edge that it stands on until its centre is nearly above that.
  const Real far = std::sqrt(kBoard.x() * kBoard.x() + kBoard.z() * kBoard.z());
  const Real angle = carom::arctangent2(kBoard.x(), kBoard.z()) + 1e-6;
  const Vector3 above(far * 1e-6, 0, far);
  std::vector<Actor> actors = {addBox(world, "board", kBoard, above,
                                      {carom::cosine(angle / 2), 0, carom::sine(angle / 2), 0})};
  for (int i = 0; i < 6; ++i) {
    const std::string name = std::string(i < 3 ? "left " : "right ") + std::to_string(i % 3);
    const Real gap = 0.002 * (i % 3 + 1);
    actors.push_back(addBox(world, name, Vector3::Constant(kHalf),
                            {-1.2, i < 3 ? -0.8 : 0.8, kHalf + 2 * kHalf * (i % 3) + gap}));
  }

  carom::io::Recording recording("Who sleeps?",
                                 "A board on its edge and two towers. Bodies that sleep are grey.");
  recording.addFixed("floor", carom::io::Plane{.size = 8, .gridStep = 0.5});
  for (const Actor& actor : actors) {
    const carom::io::Box look{2 * actor.halfExtents};
    recording.addBody(actor.name, look, {.color = carom::io::kVermilion});
    recording.addBody(actor.name + " asleep", look, {.color = carom::io::Color{150, 150, 150}});
  }
  recording.addChannel("bodies awake", "");
  recording.setView({.target = Vector3(0, 0, 0.7), .distance = 6});

  std::vector<Real> times, ofBoard, ofTower;
  for (int n = 0; n < 600; ++n) {
    if (n == 540) world.push(actors[1].id, {0, -300, 0}, {-1.2, -0.8, 0.4});
    world.step(kStep);
    for (Actor& actor : actors) {
      const Real t = world.time();
      if (speedOf(world, actor) > world.settings().sleepSpeed) actor.slowSince = t;
      const bool slow = t - actor.slowSince >= world.settings().sleepTime - kStep / 2;
      if (actor.slowAt == 0 && slow) actor.slowAt = t;
      if (actor.asleepAt == 0 && world.asleep(actor.id)) actor.asleepAt = t;
    }
    if (n < 400) {
      times.push_back(world.time());
      ofBoard.push_back(std::max(speedOf(world, actors[0]), 1e-7));
      ofTower.push_back(std::max(speedOf(world, actors[6]), 1e-7));
    }
    if (n % 2 == 1) recording.addFrame(frameOf(world, actors));
    if (n != 530) continue;

    //! [ask]
    std::vector<carom::IndexPair> contacts;
    for (const auto& pair : world.touching()) {
      contacts.push_back(carom::pairOf(pair.bodyA.index, pair.bodyB.index));
    }
    std::vector<std::uint8_t> movable(world.bodies().size(), 1);
    movable[0] = 0;  // the floor came first
    std::vector<std::uint8_t> asleep = movable;
    std::vector<std::int32_t> island(movable.size());
    carom::world::findIslands(contacts, movable, island);
    carom::world::wake(actors[1].id.index, contacts, movable, asleep);
    //! [ask]
    carom::io::Table table;
    table.column("body").column("slow for 0.5 s at", carom::io::fixed(2));
    table.column("sleeps at", carom::io::fixed(2)).column("island").column("a push wakes it");
    for (const auto& [name, id, half, since, slowAt, asleepAt] : actors) {
      table.row({name, slowAt, asleepAt, island[id.index], asleep[id.index] ? "no" : "yes"});
    }
    std::cout << "A push on left 0\n\n" << table << '\n';
  }
  std::cout << "Awake a second after the push:";
  for (const Actor& a : actors) std::cout << (world.asleep(a.id) ? "" : " [" + a.name + "]");
  std::cout << '\n';
  recording.writeHtml(folder / "falling_asleep.html");

  carom::io::Plot plot("The speed of the farthest point");
  plot.describe(
      "The board's speed grows like an exponential from a micrometre per second; that of "
      "a box of a tower falls to nothing.");
  plot.xAxis("time [s]").yAxis("speed [m/s]", carom::io::Scale::Logarithmic).size(760, 420);
  plot.curve("board", times, ofBoard).curve("top of a tower", times, ofTower);
  plot.curve("limit of speed", {0, 7}, {0.05, 0.05}, {.dashed = true});
  plot.writeSvg(folder / "falling_asleep.svg");
}
