#pragma once
// Small worlds for the tests of the world.

#include <algorithm>
#include <numbers>

#include "carom/world/world.hpp"

namespace carom_test {

using namespace carom;
using world::BodyDescription;
using world::BodyId;
using world::BodyKind;
using world::ShapeDescription;
using world::World;
using world::WorldSettings;

constexpr Real kStep = 1.0 / 60;
constexpr Real kGravity = 9.81;

inline WorldSettings awake() {
  WorldSettings settings;
  settings.sleeping = false;
  return settings;
}

inline WorldSettings weightless() {
  WorldSettings settings = awake();
  settings.gravity = Vector3::Zero();
  return settings;
}

inline ShapeDescription made(const Shape& shape, Real friction, Real restitution) {
  ShapeDescription description;
  description.shape = shape;
  description.material.friction = friction;
  description.material.restitution = restitution;
  return description;
}

// A plane through a point.
inline BodyId addPlane(World& world, Real friction, Real restitution,
                       const Vector3& normal = Vector3::UnitZ(),
                       const Vector3& point = Vector3::Zero()) {
  BodyDescription body;
  body.kind = BodyKind::immovable;
  body.shapes = {made(makeHalfSpace(normal, point), friction, restitution)};
  return world.add(body);
}

struct Thing {
  Real mass = 1;
  Vector3 position = Vector3::Zero();
  Vector3 velocity = Vector3::Zero();
  Vector3 angularVelocity = Vector3::Zero();
  Quaternion orientation = {};
  Real friction = 0;
  Real restitution = 0;
};

inline BodyId add(World& world, const Shape& shape, Real volume, const Thing& thing) {
  BodyDescription body;
  body.position = thing.position;
  body.orientation = thing.orientation;
  body.velocity = thing.velocity;
  body.angularVelocity = thing.angularVelocity;
  body.shapes = {made(shape, thing.friction, thing.restitution)};
  body.shapes[0].density = thing.mass / volume;
  return world.add(body);
}

inline BodyId addBall(World& world, Real radius, const Thing& thing) {
  return add(world, Ball{radius}, 4 * std::numbers::pi / 3 * radius * radius * radius, thing);
}

inline BodyId addBox(World& world, const Vector3& halfExtents, const Thing& thing) {
  return add(world, Box{halfExtents}, 8 * halfExtents.prod(), thing);
}

inline void run(World& world, int steps, Real dt = kStep) {
  for (int k = 0; k < steps; ++k) world.step(dt);
}

// The largest share of its energy that one of so many steps adds; zero if none does.
inline Real gainedBy(World& world, int steps) {
  Real most = 0;
  for (int k = 0; k < steps; ++k) {
    const Real before = world.energy();
    world.step(kStep);
    most = std::max(most, world.energy() / before - 1);
  }
  return most;
}

}  // namespace carom_test
