// Scenes that were built to be hard.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <sstream>

#include "carom/core/random.hpp"
#include "scenes/stress.hpp"
#include "support/random_shapes.hpp"
#include "unit/world/scene_parts.hpp"

namespace carom::stress {
namespace {

using namespace carom_test;
using carom_test::addPlane;

// A world that is run and asked; the first answer that is wrong ends the trial.
class Course {
 public:
  explicit Course(World& asked) : world(asked) {
    outcome.tally.scenes = 1;
    outcome.tally.bodies = world.bodyCount();
  }

  // Steps on while nothing is wrong. look: what is wrong, if anything.
  void run(Real seconds, Real dt, const std::function<void()>& look) {
    const long steps = std::max(1L, std::lround(seconds / dt));
    for (long k = 0; k < steps && outcome.failure.empty(); ++k) {
      world.step(dt);
      ++outcome.tally.steps;
      outcome.tally.contacts += world.counters().contactPoints;
      outcome.tally.impacts += world.counters().impacts;
      outcome.tally.searches += world.counters().firstContacts;
      for (const BodyId body : world.bodies()) {
        need(world.position(body).allFinite() && world.velocity(body).allFinite() &&
                 world.angularVelocity(body).allFinite(),
             "a number that is none", 0);
      }
      look();
    }
  }

  void need(bool holds, const std::string& what, Real value) {
    if (holds || !outcome.failure.empty()) return;
    std::ostringstream text;
    text.precision(4);
    text << what << ": " << value << " at " << world.time() << " s";
    outcome.failure = text.str();
  }

  // Notes what was gained beside a scale, and refuses more than a share of it.
  void gain(Real energy, Real before, Real scale, Real most) {
    const Real share = (energy - before) / scale;
    outcome.tally.gain = std::max(outcome.tally.gain, share);
    need(share <= most, "energy gained, as a share", share);
  }

  World& world;
  Outcome outcome;
};

// --- Hours

constexpr Real kHour = 3600;

// Steps everything: nothing sleeps, nothing that is still is left out.
WorldSettings restless() {
  WorldSettings settings = awake();
  settings.keepStill = false;
  return settings;
}

Outcome restingBoxes(Real share) {
  World world(restless());
  addPlane(world, 0.5, 0);
  std::vector<BodyId> boxes;
  std::vector<Vector3> places;
  for (int tower = 0; tower < 3; ++tower) {
    for (int i = 0; i <= tower; ++i) {
      const Vector3 place(3.0 * tower + 0.1 * i, 0.05 * i, 0.5 + i);
      places.push_back(place);
      boxes.push_back(
          addBox(world, Vector3::Constant(0.5), {.mass = 100, .position = place, .friction = 0.5}));
    }
  }
  Course course(world);
  const Real before = world.energy();
  course.run(share * 2 * kHour, kStep, [&] {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Real way = (world.position(boxes[i]) - places[i]).norm();
      course.need(way < 1e-8, "a box at rest has gone [m]", way);
    }
    course.gain(world.energy(), before, before, 1e-8);
  });
  return course.outcome;
}

Outcome freeRotor(Real share) {
  World world(weightless());
  const BodyId body =
      addBox(world, {1, 0.5, 0.25}, {.mass = 3, .angularVelocity = {0.01, 5, 0.02}});
  Course course(world);
  const Real energy = world.energy();
  const Vector3 momentum = world.angularMomentum();
  course.run(share * 4 * kHour, kStep, [&] {
    const Real lost = std::abs(world.energy() / energy - 1);
    const Real turned = (world.angularMomentum() - momentum).norm() / momentum.norm();
    course.outcome.tally.gain = std::max(course.outcome.tally.gain, lost);
    course.need(lost < 1e-12, "energy of a free rotor, relative", lost);
    course.need(turned < 1e-12, "angular momentum of a free rotor, relative", turned);
    course.need(world.position(body).norm() < 1e-12, "a free rotor has gone [m]",
                world.position(body).norm());
  });
  return course.outcome;
}

// A tall top that stands on the floor and spins fast enough to stay upright.
Outcome spinningTop(Real share) {
  World world(restless());
  addPlane(world, 1, 0);
  const BodyId top =
      add(world, Ball{0.2}, 4 * std::numbers::pi / 3 * 0.008,
          {.mass = 1, .position = {0, 0, 0.2}, .angularVelocity = {0, 0, 100}, .friction = 1});
  Course course(world);
  const Real before = world.energy();
  course.run(share * kHour, kStep, [&] {
    course.gain(world.energy(), before, before, 1e-9);
    const Real way = (world.position(top) - Vector3(0, 0, 0.2)).norm();
    course.need(way < 1e-6, "a top that spins in place has gone [m]", way);
  });
  return course.outcome;
}

void addRoom(World& world, Real half, Real friction, Real restitution) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const Real side : {-1.0, 1.0}) {
      Vector3 out = Vector3::Zero();
      out[axis] = side;
      addPlane(world, friction, restitution, -out, half * out);
    }
  }
}

Outcome elasticBalls(Real share) {
  World world(restless());
  addRoom(world, 2, 0, 1);
  Random random(5);
  for (int i = 0; i < 8; ++i) {
    const Vector3 place(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    addBall(world, 0.25 + 0.05 * (i % 3),
            {.mass = 1.0 + i, .position = place, .velocity = random.vector(3), .restitution = 1});
  }
  Course course(world);
  // Height counts from the floor.
  Real weights = 0;
  for (const BodyId body : world.bodies()) {
    if (std::isfinite(world.mass(body))) weights += world.mass(body) * kGravity;
  }
  const Real before = world.energy() + 2 * weights;
  course.run(share * kHour, kStep, [&] {
    const Real now = world.energy() + 2 * weights;
    course.gain(now, before, before, 1e-9);
    course.need(now > before * (1 - 1e-9), "elastic balls have lost energy, relative",
                1 - now / before);
    for (const BodyId body : world.bodies()) {
      const Real out = world.position(body).cwiseAbs().maxCoeff() - 1.75;
      course.need(out < 1e-6, "a ball is outside of the walls [m]", out);
    }
  });
  return course.outcome;
}

Outcome rollingInABowl(Real share) {
  World world(restless());
  BodyDescription ground;
  ground.kind = BodyKind::immovable;
  ground.shapes = {made(Ball{}, 0.7, 0)};
  ground.shapes[0].ground = std::make_shared<TriangleMesh>(
      sheetOf(4, 16, [](Real x, Real y) { return (x * x + y * y) / 8; }));
  world.add(ground);
  const BodyId ball = addBall(
      world, 0.3, {.mass = 2, .position = {2, 0.1, 0.9}, .velocity = {0, 1.5, 0}, .friction = 0.7});
  Course course(world);
  const Real before = world.energy();
  course.run(share * kHour, kStep, [&] {
    course.gain(world.energy(), before, before, 1e-9);
    const Vector3 at = world.position(ball);
    const Real deep = (at.x() * at.x() + at.y() * at.y()) / 8 - at.z();
    course.need(deep < 0, "the ball is below the bowl [m]", deep);
  });
  return course.outcome;
}

// --- Ratios

// A light ball between a wall and one a million times as heavy; then a heavy box on a light one.
Outcome massRatios(Real share) {
  Outcome sum;
  for (const Real ratio : {1e2, 1e4, 1e6}) {
    World world(weightless());
    const BodyId light = addBall(world, 0.1, {.position = {0, 0, 0}, .restitution = 1});
    const BodyId heavy =
        addBall(world, 0.5,
                {.mass = ratio, .position = {-2, 0, 0}, .velocity = {1, 0, 0}, .restitution = 1});
    Course course(world);
    const Real before = world.energy();
    course.run(2, kStep, [&] { course.gain(world.energy(), before, before, 1e-12); });
    const Real vLight = 2 * ratio / (1 + ratio), vHeavy = (ratio - 1) / (1 + ratio);
    course.need(std::abs(world.velocity(light).x() - vLight) < 1e-12, "speed of the light one",
                world.velocity(light).x());
    course.need(std::abs(world.velocity(heavy).x() - vHeavy) < 1e-12, "speed of the heavy one",
                world.velocity(heavy).x());
    sum.tally.add(course.outcome.tally);
    if (sum.failure.empty()) sum.failure = course.outcome.failure;
  }
  for (const Real ratio : {1e2, 1e4, 1e6}) {
    for (const bool heavyAbove : {false, true}) {
      World world(restless());
      addPlane(world, 0.5, 0);
      const Vector3 half = Vector3::Constant(0.5);
      std::vector<BodyId> boxes;
      for (int i = 0; i < 4; ++i) {
        const bool heavy = (i % 2 == 1) == heavyAbove;
        boxes.push_back(addBox(
            world, half,
            {.mass = heavy ? ratio : 1, .position = {0.02 * i, 0, 0.5 + i}, .friction = 0.5}));
      }
      Course course(world);
      const Real before = world.energy();
      course.run(share * 600, kStep, [&] {
        course.gain(world.energy(), before, before, 1e-8);
        for (int i = 0; i < 4; ++i) {
          const Real way =
              (world.position(boxes[static_cast<std::size_t>(i)]) - Vector3(0.02 * i, 0, 0.5 + i))
                  .norm();
          course.need(way < 1e-4, "a box of a tower of masses has gone [m]", way);
        }
      });
      sum.tally.add(course.outcome.tally);
      if (sum.failure.empty()) sum.failure = course.outcome.failure;
    }
  }
  return sum;
}

// Needles, plates and slivers, a thousand times as long as thick, thrown into a room.
Outcome slivers(Real share) {
  Outcome sum;
  const int scenes = std::max(1, static_cast<int>(std::lround(100 * share)));
  for (int scene = 0; scene < scenes && sum.failure.empty(); ++scene) {
    Random random(static_cast<std::uint64_t>(scene) + 1);
    World world(restless());
    addRoom(world, 4, 0.5, 0);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 8; ++i) {
      const Vector3 place(i & 1 ? 1.6 : -1.6, i & 2 ? 1.6 : -1.6, i & 4 ? 1.6 : -1.6);
      Thing thing{.mass = random.between(0.1, 10), .position = place};
      thing.velocity = random.vector(3);
      thing.angularVelocity = random.vector(2);
      thing.friction = random.between(0, 1);
      thing.restitution = i % 2 == 0 ? 0 : random.between(0, 1);
      const int kind = i % 4;
      if (kind == 0) bodies.push_back(addBox(world, {1, 0.001, 0.001}, thing));
      if (kind == 1) bodies.push_back(addBox(world, {0.8, 0.8, 0.0008}, thing));
      if (kind == 2) bodies.push_back(addBox(world, {1, 0.03, 0.001}, thing));
      if (kind == 3) {
        bodies.push_back(add(world, Capsule{0.001, 1}, std::numbers::pi * 1e-6 * 2, thing));
      }
    }
    Course course(world);
    Real weights = 0;
    for (const BodyId body : bodies) weights += world.mass(body) * kGravity;
    const Real before = world.energy() + 4 * weights;
    course.run(3, kStep, [&] {
      course.gain(world.energy() + 4 * weights, before, before, 1e-6);
      for (const BodyId body : bodies) {
        const Real out = world.position(body).cwiseAbs().maxCoeff() - 4;
        course.need(out < 0.01,
                    "a sliver is outside of the walls [m], scene " + std::to_string(scene + 1),
                    out);
      }
    });
    sum.tally.add(course.outcome.tally);
    sum.failure = course.outcome.failure;
  }
  return sum;
}

// From a millimetre to a kilometre, each falling on one that is ten times as large.
Outcome sizes(Real share) {
  World world(restless());
  addPlane(world, 0.5, 0);
  std::vector<BodyId> boxes;
  std::vector<Real> heights;
  Real top = 0;
  for (int power = 3; power >= -3; --power) {
    const Real size = std::pow(10.0, power);
    top += size + size / 100;
    heights.push_back(top - size / 2);
    boxes.push_back(addBox(world, Vector3::Constant(size / 2),
                           {.mass = 1000 * size * size * size,
                            .position = {size / 7, 0, top - size / 2},
                            .friction = 0.5}));
  }
  const BodyId pebble =
      addBall(world, 0.0005, {.mass = 1e-6, .position = {-600, 0, 2}, .restitution = 0.5});
  Course course(world);
  const Real before = world.energy();
  course.run(10 + 50 * share, kStep, [&] { course.gain(world.energy(), before, before, 1e-9); });
  Real below = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Real size = std::pow(10.0, 3 - static_cast<int>(i));
    const Real off = std::abs(world.position(boxes[i]).z() - (below + size / 2));
    below += size;
    course.need(off < 1e-6, "a box of " + std::to_string(size) + " m is off its height [m]", off);
  }
  const Real off = std::abs(world.position(pebble).z() - 0.0005);
  course.need(off < 1e-8, "the pebble is off the floor [m]", off);
  return course.outcome;
}

// A tower and bouncing balls a thousand kilometres from the origin, beside the same at the origin.
Outcome farAway(Real share) {
  const Vector3 far(1e6, -1e6, 0);
  const auto build = [](World& world, const Vector3& middle) {
    std::vector<BodyId> bodies;
    addPlane(world, 0.5, 0.5);
    for (int i = 0; i < 4; ++i) {
      bodies.push_back(
          addBox(world, Vector3::Constant(0.5),
                 {.mass = 10, .position = middle + Vector3(0, 0, 0.5 + i), .friction = 0.5}));
    }
    for (int i = 0; i < 4; ++i) {
      bodies.push_back(addBall(world, 0.25,
                               {.position = middle + Vector3(3 + i, 2, 1 + i),
                                .velocity = {0.5, 0, 0},
                                .restitution = 0.5}));
    }
    return bodies;
  };
  World here(restless()), there(restless());
  const std::vector<BodyId> near = build(here, Vector3::Zero());
  const std::vector<BodyId> away = build(there, far);
  Course course(there);
  const Real before = there.energy();
  course.run(std::max(Real(3), share * 600), kStep, [&] {
    here.step(kStep);
    course.gain(there.energy(), before, before, 1e-8);
    for (std::size_t i = 0; i < near.size(); ++i) {
      const Real off = (there.position(away[i]) - far - here.position(near[i])).norm();
      course.need(off < 1e-6, "differs from the same at the origin [m]", off);
    }
  });
  return course.outcome;
}

// --- Overlap

// Bodies in each other at the start. Without weight they come apart and stay at rest; with it they
// gain at most the height by which they were lifted: their own.
Outcome overlaps(Real share) {
  Outcome sum;
  const int scenes = std::max(1, static_cast<int>(std::lround(100 * share)));
  for (int scene = 0; scene < scenes && sum.failure.empty(); ++scene) {
    for (const bool heavy : {false, true}) {
      Random random(static_cast<std::uint64_t>(scene) + 1);
      WorldSettings settings = restless();
      if (!heavy) settings.gravity = Vector3::Zero();
      World world(settings);
      addPlane(world, 0.5, 0);
      std::vector<BodyId> bodies;
      Real weights = 0;
      for (int i = 0; i < 6; ++i) {
        const Real mass = random.between(1, 10);
        Thing thing{.mass = mass, .friction = 0.5};
        thing.position = Vector3(0, 0, 0.8) + random.vector(0.5);
        const Vector3 half = Vector3::Constant(0.3) + random.vector(0.1);
        bodies.push_back(i % 2 == 0 ? addBox(world, half, thing) : addBall(world, 0.3, thing));
        weights += mass * kGravity;
      }
      Course course(world);
      const Real before = world.energy();
      Real moving = 0;
      course.run(3, kStep, [&] {
        Real motion = 0;
        for (const BodyId body : bodies) {
          const Vector3 w = world.angularVelocity(body);
          motion += (world.mass(body) * world.velocity(body).squaredNorm() +
                     w.dot(world.inertia(body) * w)) /
                    2;
        }
        moving = motion;
        if (!heavy) course.need(motion < 1e-20, "without weight overlap made speed [J]", motion);
        if (heavy) course.gain(world.energy(), before, 2 * weights, 1);
      });
      for (const auto& pair : world.touching()) {
        course.outcome.tally.depth = std::max(course.outcome.tally.depth, -pair.separation);
        course.need(pair.separation > -1e-3,
                    "still overlaps [m], scene " + std::to_string(scene + 1), pair.separation);
      }
      if (heavy) course.need(moving < 0.1 * weights, "still moves after 3 s [J]", moving);
      sum.tally.add(course.outcome.tally);
      if (sum.failure.empty()) sum.failure = course.outcome.failure;
    }
  }
  return sum;
}

}  // namespace

const std::vector<Trial>& trials() {
  static const std::vector<Trial> all{
      {"boxes", "towers at rest for two hours, stepped all the time", restingBoxes},
      {"rotor", "a free rotor about its middle axis for four hours", freeRotor},
      {"top", "a ball that spins in place for an hour", spinningTop},
      {"balls", "elastic balls in a box for an hour", elasticBalls},
      {"bowl", "a ball that rolls in a bowl of triangles for an hour", rollingInABowl},
      {"masses", "blows and towers of masses up to one to a million", massRatios},
      {"slivers", "needles, plates and slivers, one to a thousand", slivers},
      {"sizes", "from a millimetre to a kilometre in one tower", sizes},
      {"far", "a million metres from the origin", farAway},
      {"overlap", "bodies that start deep in each other", overlaps}};
  return all;
}

}  // namespace carom::stress
