// The small worlds of chapter 5: what a step must keep, and where its motions must end.

#include <cmath>
#include <limits>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/mass/box_inertia.hpp"
#include "planar_world.hpp"
#include "reference.hpp"
#include "spatial_world.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

PlanarWorldBody disc(Real radius, const Vector2& position, const Vector2& velocity) {
  PlanarWorldBody body;
  body.shape = makeDisc(radius);
  body.motion = {planarBodyMass(1, radius * radius / 2), {velocity, 0}};
  body.position = position;
  return body;
}

Real energyOf(const PlanarWorld& world) {
  Real energy = 0;
  for (const PlanarWorldBody& body : world.bodies) {
    const auto& [mass, velocity] = body.motion;
    if (mass.inverseMass > 0) energy += velocity.linear.squaredNorm() / mass.inverseMass / 2;
    if (mass.inverseInertia > 0) {
      energy += velocity.angular * velocity.angular / mass.inverseInertia / 2;
    }
  }
  return energy;
}

SpatialWorld onFloor(const SpatialWorldBody& body) {
  SpatialWorld world;
  SpatialWorldBody floor;
  floor.shape = HalfSpace{};
  floor.friction = body.friction;
  floor.restitution = 1;
  world.bodies = {floor, body};
  return world;
}

MassProperties weight(Real mass, const Matrix3& inertia) {
  MassProperties body;
  body.mass = mass;
  body.inertia = inertia;
  return body;
}

}  // namespace

TEST_CASE("discs meet at the right moment, however long the step is") {
  // Two at 5 m/s, gap 1 m, and a third one that waits, touching nothing.
  for (const int steps : {1, 3, 60, 1000}) {
    PlanarWorld world;
    world.bodies = {disc(0.5, {0, 0}, {5, 0}), disc(0.5, {2, 0}, {0, 0}),
                    disc(0.5, {4, 0}, {0, 0})};
    for (int i = 0; i < steps; ++i) step(world, 1.0 / steps);
    INFO(steps << " steps");
    CHECK(std::abs(world.bodies[0].position.x() - 1) < 1e-12);  // stopped where it met the second
    CHECK(std::abs(world.bodies[1].position.x() - 3) < 1e-12);
    CHECK(std::abs(world.bodies[2].position.x() - (4 + 5 * (1 - 0.4))) < 1e-12);
    CHECK(world.impacts == 2);
  }
}

TEST_CASE("a cradle in the planar world: two in, two out, to the last bit") {
  PlanarWorld world;
  for (int i = 0; i < 5; ++i) {
    const Real gap = i < 2 ? 0.0 : 1.0;
    world.bodies.push_back(disc(0.5, {i + gap, 0}, {i < 2 ? 1.0 : 0.0, 0}));
  }
  for (int i = 0; i < 120; ++i) step(world, 1.0 / 60);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(world.bodies[i].motion.velocity.linear.x() == (i < 3 ? 0 : 1));
  }
}

TEST_CASE("a break on a table with four cushions keeps its energy") {
  PlanarWorld world;
  world.walls = {{{1, 0}, -4}, {{-1, 0}, -6}, {{0, 1}, -3}, {{0, -1}, -3}};
  world.bodies = {disc(0.3, {-3, 0.1}, {6, 0.3})};
  for (int r = 0; r < 4; ++r) {
    for (int k = 0; k <= r; ++k) {
      world.bodies.push_back(
          disc(0.3, {0.6 * std::sqrt(0.75) * r * 1.0000001, 0.6 * k - 0.3 * r}, {0, 0}));
    }
  }
  const Real energy = energyOf(world);
  for (int i = 0; i < 300; ++i) {
    step(world, 1.0 / 60);
    REQUIRE(std::abs(energyOf(world) - energy) < 1e-12 * energy);
    for (const PlanarWorldBody& body : world.bodies) {
      REQUIRE(std::abs(body.position.y()) < 2.7 + 1e-6);
    }
  }
  CHECK(std::abs(world.time - 5) < 1e-9);
  CHECK(world.impacts > 20);
}

TEST_CASE("a compound that is hit off-centre turns, and momenta are kept") {
  PlanarWorld world;
  const Vector2 bar[4] = {{-1, -0.1}, {1, -0.1}, {1, 0.1}, {-1, 0.1}};
  PlanarWorldBody body;
  body.shape = makePlanarCompound({{makePolygon(bar), {}}, {makeDisc(0.2), {1, 0, {-0.8, 0}}}});
  body.motion.mass = planarBodyMass(2, 0.7);
  world.bodies = {disc(0.25, {0.7, -1}, {0, 2}), body};
  const auto angular = [&] {
    Real sum = 0;
    for (const PlanarWorldBody& b : world.bodies) {
      const auto& [mass, v] = b.motion;
      sum += (b.position.x() * v.linear.y() - b.position.y() * v.linear.x()) / mass.inverseMass +
             v.angular / mass.inverseInertia;
    }
    return sum;
  };
  const Real before = angular(), energy = energyOf(world);
  for (int i = 0; i < 60; ++i) step(world, 1.0 / 60);
  CHECK(world.bodies[1].motion.velocity.angular > 1);
  CHECK(std::abs(2 * world.bodies[1].motion.velocity.linear.y() +
                 world.bodies[0].motion.velocity.linear.y() - 2) < 1e-14);
  CHECK(std::abs(angular() - before) < 0.02);  // pushing apart moves bodies by a millimetre
  CHECK(std::abs(energyOf(world) - energy) < 1e-12);
}

TEST_CASE("a planar box slides to rest and then stays") {
  PlanarWorld world;
  world.gravity = {0, -9.81};
  const Vector2 floor[4] = {{-50, -1}, {50, -1}, {50, 1}, {-50, 1}};
  const Vector2 square[4] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  PlanarWorldBody ground, box;
  ground.shape = makePolygon(floor);
  ground.position = {0, -1};
  box.shape = makePolygon(square);
  box.motion = {planarBodyMass(1, 1.0 / 6), {{4, 0}, 0}};
  box.position = {0, 0.5};
  for (PlanarWorldBody* body : {&ground, &box}) body->friction = 0.3, body->restitution = 0;
  world.bodies = {ground, box};
  for (int i = 0; i < 180; ++i) step(world, 1.0 / 60);
  const PlanarWorldBody& moved = world.bodies[1];
  const Real exact = number(impulseCase("I6")["stop_distance"]);
  CHECK(std::abs(moved.position.x() - exact) < 0.05);
  CHECK(moved.motion.velocity.linear.norm() < 1e-12);
  CHECK(std::abs(moved.position.y() - 0.5) < 1e-3);
  const Real rests = moved.position.x();
  for (int i = 0; i < 60; ++i) step(world, 1.0 / 60);
  CHECK(std::abs(world.bodies[1].position.x() - rests) < 1e-12);
}

TEST_CASE("a spatial box slides straight and stops where Coulomb says, to half a step") {
  SpatialWorldBody box =
      movableBody(makeBox({0.5, 0.5, 0.2}), weight(1, boxInertia(1, {1, 1, 0.4})), {0, 0, 0.2},
                  {{4, 0, 0}, {0, 0, 0}});
  box.friction = 0.3;
  SpatialWorld world = onFloor(box);
  for (int i = 0; i < 120; ++i) step(world, 1.0 / 60);
  const SpatialWorldBody& moved = world.bodies[1];
  CHECK(std::abs(moved.position.x() - number(impulseCase("I6")["stop_distance"])) < 0.04);
  CHECK(std::abs(moved.position.y()) < 1e-12);
  CHECK(moved.motion.velocity.linear.norm() < 1e-12);
}

TEST_CASE("a spatial ball ends with five sevenths of its speed") {
  SpatialWorldBody ball = movableBody(makeBall(1), weight(1, 0.4 * Matrix3::Identity()), {0, 0, 1},
                                      {{7, 0, 0}, {0, 0, 0}});
  ball.friction = 0.2;
  SpatialWorld world = onFloor(ball);
  for (int i = 0; i < 120; ++i) step(world, 1.0 / 60);
  const Velocity& v = world.bodies[1].motion.velocity;
  CHECK(std::abs(v.linear.x() - number(impulseCase("I7")["v_roll"])) < 1e-12);
  CHECK(std::abs(v.angular.y() - v.linear.x()) < 1e-12);
  // Cloth in front of the ball stops it in the end.
  world.bodies[1].rollingArm = 0.05;
  for (int i = 0; i < 1800; ++i) step(world, 1.0 / 60);
  CHECK(world.bodies[1].motion.velocity.linear.norm() < 1e-12);
}

TEST_CASE("a top that stands on a disc stops spinning at the time of case I9") {
  const Real R = 0.1;
  SpatialWorldBody top =
      movableBody(makeCylinder(R, 0.02), weight(1, Vector3(0.003, 0.003, R * R / 2).asDiagonal()),
                  {0, 0, 0.02}, {{0, 0, 0}, {0, 0, 50}});
  top.friction = 0.25;
  top.patchRadius = R;
  SpatialWorld world = onFloor(top);
  Real stopped = 0;
  for (int i = 0; i < 600; ++i) {
    step(world, 1.0 / 240);
    if (stopped == 0 && world.bodies[1].motion.velocity.angular.norm() < 1e-9) stopped = world.time;
  }
  CHECK(std::abs(stopped - number(impulseCase("I9")["stop_time"])) < 2.0 / 240);
}

TEST_CASE("a parachute sinks at the speed at which drag carries the weight") {
  SpatialWorldBody jumper =
      movableBody(makeBall(0.3), weight(80, 3 * Matrix3::Identity()), {0, 0, 3000}, {});
  jumper.air = {.wind = {2, 0, 0}, .density = 1.2, .coefficient = 1.5, .area = 30};
  SpatialWorld world;
  world.bodies = {jumper};
  for (int i = 0; i < 1200; ++i) step(world, 1.0 / 60);
  const Vector3& v = world.bodies[0].motion.velocity.linear;
  CHECK(std::abs(v.z() + std::sqrt(2 * 80 * 9.81 / (1.2 * 1.5 * 30))) < 1e-9);
  CHECK(std::abs(v.x() - 2) < 1e-6);  // it drifts with the wind
}

TEST_CASE("a ball that bounces comes to rest in about the time of case I10, and does not sink") {
  const json expected = impulseCase("I10");
  SpatialWorldBody ball =
      movableBody(makeBall(0.1), weight(1, 0.004 * Matrix3::Identity()), {0, 0, 1.1});
  ball.restitution = 0.8;
  SpatialWorld world = onFloor(ball);
  const int restsAfter = static_cast<int>(number(expected["t_inf"]) * 240);
  for (int i = 0; i < restsAfter + 60; ++i) step(world, 1.0 / 240);
  CHECK(world.bodies[1].motion.velocity.linear.norm() < 1e-12);
  CHECK(std::abs(world.bodies[1].position.z() - 0.1) < 3e-3);
}

TEST_CASE("two balls in space that meet keep momentum, and a wall turns one round") {
  SpatialWorld world;
  world.gravity = Vector3::Zero();
  SpatialWorldBody a = movableBody(makeBall(0.5), weight(2, 0.2 * Matrix3::Identity()), {0, 0, 0},
                                   {{3, 0, 0}, {0, 0, 1}});
  SpatialWorldBody b =
      movableBody(makeBall(0.5), weight(1, 0.1 * Matrix3::Identity()), {2, 0.3, 0.2}, {});
  a.restitution = b.restitution = 1;
  a.friction = b.friction = 0.3;
  world.bodies = {a, b};
  for (int i = 0; i < 60; ++i) step(world, 1.0 / 60);
  const Vector3 momentum =
      2 * world.bodies[0].motion.velocity.linear + world.bodies[1].motion.velocity.linear;
  CHECK((momentum - Vector3(6, 0, 0)).norm() < 1e-14);
  CHECK(world.bodies[1].motion.velocity.linear.x() > 3);
}

TEST_CASE("a step needs a duration") {
  PlanarWorld planar;
  SpatialWorld spatial;
  for (const Real dt : {0.0, -1.0, std::numeric_limits<Real>::quiet_NaN()}) {
    CHECK_THROWS_AS(step(planar, dt), InvalidInput);
    CHECK_THROWS_AS(step(spatial, dt), InvalidInput);
  }
}
