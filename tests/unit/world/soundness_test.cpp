// What random scenes (the benchmark `stress`) have found, each in its smallest form.

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "carom/manifold/collide_half_space.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"

using namespace carom_test;

namespace {

// Turned by an angle about a unit vector.
Quaternion turned(const Vector3& axis, Real angle) {
  const Vector3 v = std::sin(angle / 2) * axis;
  return {std::cos(angle / 2), v.x(), v.y(), v.z()};
}

}  // namespace

TEST_CASE(
    "the impacts of an edge are told where the edge is, not at the corners still in the air") {
  const Real lean = GENERATE(-0.01, 0.01);
  const Vector3 axis = GENERATE(Vector3(1, 0, 0), Vector3(0, 1, 0));
  World world(awake());
  addPlane(world, 0, 0.5);
  const Vector3 half(0.5, 0.4, 0.3);
  addBox(world, half,
         {.position = {0, 0, 0.4}, .orientation = turned(axis, lean), .restitution = 0.5});
  int told = 0;
  for (int step = 0; step < 60 && told == 0; ++step) {
    world.step(kStep);
    for (const auto& impact : world.events().impacts) {
      // Later blows of the same step are those of the other edge.
      if (impact.time > world.events().impacts.front().time) break;
      ++told;
      CHECK(std::abs(impact.point.z()) < 1e-6);
      CHECK(impact.approach > 0);
    }
  }
  CHECK(told > 0);
}

TEST_CASE("a light ball that is thrown farther than anybody looked does not pass the floor") {
  World world(weightless());
  addPlane(world, 0, 0);
  const BodyId light =
      addBall(world, 0.05, {.mass = 0.01, .position = {0, 0, 0.4}, .restitution = 1});
  addBall(world, 0.25,
          {.mass = 10, .position = {0, 0, 1}, .velocity = {0, 0, -30}, .restitution = 1});
  // Struck in the middle of the first step, it flies at 60 m/s: beyond its box, and the floor.
  for (int step = 0; step < 2; ++step) {
    world.step(kStep);
    CHECK(world.position(light).z() > 0.049);
  }
}

TEST_CASE("a ball that has left the floor and is thrown back at it does not pass the floor") {
  World world(weightless());
  addPlane(world, 0, 0);
  // Some steps after it has left, the tree still keeps both as a pair; but nobody looks at it.
  const BodyId light =
      addBall(world, 0.05,
              {.mass = 0.01, .position = {0, 0, 0.051}, .velocity = {0, 0, 1}, .restitution = 1});
  addBall(world, 0.25,
          {.mass = 10, .position = {0, 0, 3.6}, .velocity = {0, 0, -30}, .restitution = 1});
  for (int step = 0; step < 12; ++step) {
    world.step(kStep);
    CHECK(world.position(light).z() > 0.049);
  }
}

TEST_CASE("a box that turns by radians in a step gains nothing from walls, without events either") {
  WorldSettings settings = weightless();
  settings.locateEvents = false;
  Real most = 0;
  for (int k = 0; k < 40; ++k) {
    World world(settings);
    addPlane(world, 0, 0);
    addPlane(world, 0, 0, -Vector3::UnitZ(), {0, 0, 1.1});
    const Vector3 axis = Vector3(std::sin(k), std::cos(k), 0.3).normalized();
    addBox(world, {0.5, 0.1, 0.2},
           {.position = {0, 0, 0.55},
            .velocity = {0.5, 0, -1},
            .angularVelocity = (30 + 6 * k) * axis});
    most = std::max(most, gainedBy(world, 30));
  }
  CHECK(most < 1e-3);
}

TEST_CASE("what tumbles strikes a floor when it comes there, and gains nothing by being late") {
  // After a bounce on one rim the other one comes down, in an arc that no even spin describes.
  Real most = 0;
  for (int k = 0; k < 40; ++k) {
    World world(awake());
    addPlane(world, 0, 1);
    Thing thing{.position = {0, 0, 0.5}, .restitution = 1};
    thing.angularVelocity = (6 + 0.5 * k) * Vector3(std::sin(k), std::cos(k), 0.4).normalized();
    add(world, Cylinder{0.3, 0.05 + 0.01 * k}, 1, thing);
    const Real before = world.energy();
    for (int step = 0; step < 300; ++step) {
      world.step(kStep);
      most = std::max(most, std::abs(world.energy() / before - 1));
    }
  }
  CHECK(most < 1e-12);
}

TEST_CASE("bounces in several places at once gain as little on a floor that moves") {
  WorldSettings settings = weightless();
  settings.locateEvents = false;
  const Vector3 wind = GENERATE(Vector3(0, 0, 0), Vector3(2, 1, 3));
  Real most = 0;
  for (int k = 0; k < 40; ++k) {
    World world(settings);
    BodyDescription floor;
    floor.kind = BodyKind::kinematic;
    floor.position = {0, 0, -1};
    floor.velocity = wind;
    floor.shapes = {made(Box{{9, 9, 1}}, 1, 1)};
    world.add(floor);
    std::vector<BodyId> boxes;
    for (int i = 0; i < 3; ++i) {
      const Vector3 spin(std::sin(k + i), std::cos(2 * k - i), std::sin(3 * k));
      boxes.push_back(addBox(world, {0.5, 0.3 + 0.1 * i, 0.2},
                             {.mass = std::pow(10.0, (k + i) % 3),
                              .position = {0.1 * i, 0, 0.21 + 0.405 * i},
                              .velocity = wind + Vector3(0, 0, -1 - i),
                              .angularVelocity = 3 * spin,
                              .friction = 1,
                              .restitution = 1}));
    }
    const auto energy = [&] {
      Real sum = 0;
      for (const BodyId box : boxes) {
        const Vector3 w = world.angularVelocity(box);
        sum += world.mass(box) * (world.velocity(box) - wind).squaredNorm() +
               w.dot(world.inertia(box) * w);
      }
      return sum;
    };
    Real before = energy();
    for (int step = 0; step < 20; ++step) {
      world.step(kStep);
      most = std::max(most, energy() / before - 1);
      before = energy();
    }
  }
  CHECK(most < 1e-3);
}

TEST_CASE(
    "what tumbles by radians in a step does not fall through a sheet, without events either") {
  WorldSettings settings = awake();
  settings.locateEvents = false;
  TriangleMesh sheet;
  sheet.vertices = {{-90, -90, 0}, {90, -90, 0}, {90, 90, 0}, {-90, 90, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const bool round = GENERATE(false, true);
  Real least = 1, most = 0;
  for (int k = 0; k < 100; ++k) {
    World world(settings);
    BodyDescription ground;
    ground.kind = BodyKind::immovable;
    ground.shapes = {made(Ball{}, 0.5, 0)};
    ground.shapes[0].ground = std::make_shared<TriangleMesh>(sheet);
    world.add(ground);
    const Vector3 spin(std::sin(k), std::cos(2 * k), std::sin(3 * k));
    const Thing thing{.position = {0, 0, 0.6},
                      .velocity = {1, 0, -8},
                      .angularVelocity = (50 + 10 * k) * spin,
                      .friction = 0.5};
    const BodyId body = round ? add(world, Capsule{0.02, 0.5}, 1e-3, thing)
                              : addBox(world, {0.5, 0.1, 0.02}, thing);
    const Real first = world.energy();
    Real energy = first;
    for (int step = 0; step < 60; ++step) {
      world.step(kStep);
      least = std::min(least, world.position(body).z());
      most = std::max(most, (world.energy() - energy) / first);
      energy = world.energy();
    }
  }
  CHECK(least > 0);
  CHECK(most < 1e-3);
}

TEST_CASE("a box that turns by radians in a step gains nothing from walls, by soft steps either") {
  WorldSettings settings = weightless();
  settings.pileContacts = 0;
  Real most = 0;
  for (int k = 0; k < 40; ++k) {
    World world(settings);
    addPlane(world, 0, 0.5);
    addPlane(world, 0, 0.5, -Vector3::UnitZ(), {0, 0, 1.1});
    const Vector3 axis = Vector3(std::sin(k), std::cos(k), 0.3).normalized();
    addBox(world, {0.5, 0.1, 0.2},
           {.position = {0, 0, 0.55},
            .velocity = {0.5, 0, -1},
            .angularVelocity = (6 + 1.2 * k) * axis,
            .restitution = 0.5});
    const Real energy = world.energy();
    for (int step = 0; step < 30; ++step) {
      world.step(kStep);
      most = std::max(most, world.energy() / energy - 1);
    }
  }
  CHECK(most < 1e-9);
}

TEST_CASE("bodies without weight that are pushed out of each other gain nothing by being turned") {
  Real most = 0;
  for (int k = 0; k < 60; ++k) {
    World world(weightless());
    const Vector3 spin(std::sin(k), std::cos(2 * k), std::sin(3 * k));
    addBox(world, {0.5, 0.3, 0.1}, {.velocity = {0, 0, -1}, .angularVelocity = spin});
    addBox(world, {0.2, 0.4, 0.3},
           {.mass = 2,
            .position = {0.3 * std::sin(5 * k), 0.1, 0.397},
            .velocity = {0, 0, 1},
            .angularVelocity = -spin});
    const Real energy = world.energy();
    for (int step = 0; step < 20; ++step) {
      world.step(kStep / 4);
      most = std::max(most, world.energy() / energy - 1);
    }
  }
  CHECK(most < 1e-9);
}

TEST_CASE("a disc that lies deep in the floor is held all around, not at its lowest point only") {
  const HalfSpace floor = makeHalfSpace(Vector3::UnitZ(), Vector3::Zero());
  const Quaternion q = turned(Vector3::UnitX(), 0.5);
  const Real deep = GENERATE(0.0, -0.1, -0.4);
  const Vector3 middle(0, 0, deep);
  const Manifold found =
      collideHalfSpace(floor, Pose{}, Cylinder{0.5, 0.1}, poseOf(q, middle), 0.01);
  Real left = 0, right = 0, least = 0;
  for (int i = 0; i < found.count; ++i) {
    const ManifoldPoint& point = found.points[static_cast<std::size_t>(i)];
    left = std::min(left, point.position.y());
    right = std::max(right, point.position.y());
    least = std::min(least, point.separation);
  }
  CHECK(left < -0.2);
  if (deep < -0.3) CHECK(right > 0.2);
  CHECK(std::abs(least - (deep - 0.5 * std::sin(0.5) - 0.1 * std::cos(0.5))) < 1e-12);
}
