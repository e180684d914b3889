#pragma once
// Scenes whose end is known beside the world: what race and work_precision measure with.

#include <cmath>
#include <string>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/elementary.hpp"
#include "carom/impulse/bouncing_ball.hpp"
#include "carom/impulse/roll_ball.hpp"
#include "carom/world/world.hpp"

using carom::Real;
using carom::Vector3;
using carom::world::BodyId;
using carom::world::World;

constexpr Real kEarth = 9.81;  // [m/s^2]

/// A body's part in a scene, and how wrong it is at a time. \ingroup world
struct Known {
  /// Puts it into a world. \ingroup world
  using Add = BodyId (*)(World&);
  /// How far it is from where it should be [m or rad]. \ingroup world
  using Error = Real (*)(const World&, BodyId, Real time);
  std::string name;       ///< what it is
  Add add = nullptr;      ///< puts it into a world
  Error error = nullptr;  ///< how wrong it is
};

inline void addGround(World& world) {
  world.add({.kind = carom::world::BodyKind::immovable,
             .shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero()),
                         .material = {.friction = 1}}}});
}

// Friction of a pair is the root of the product of its two.
inline carom::world::ShapeDescription made(const carom::Shape& shape, Real friction, Real bounce) {
  return {.shape = shape, .material = {.friction = friction * friction, .restitution = bounce}};
}

// --- A box of 0.2 x 0.5 x 1 m, pushed at 1.2 rad/s over its right lower edge

inline BodyId addTipping(World& world) {
  return world.add({.position = {-0.1, 0, 0.5},
                    .velocity = {0.6, 0, 0.12},
                    .angularVelocity = {0, 1.2, 0},
                    .shapes = {made(carom::makeBox({0.1, 0.25, 0.5}), 1, 0)}});
}

// Energy gives the speed at any angle, and time is the integral of
// d(angle) / speed. Late by so much is wrong by that times the speed.
inline Real tippingError(const World& world, BodyId box, Real time) {
  const carom::Quaternion q = world.orientation(box);
  const Real tilt = 2 * carom::arctangent2(q.y, q.w);
  const auto speed = [](Real angle) {
    const Real lifted = 0.5 * (carom::cosine(angle) - 1) + 0.1 * carom::sine(angle);
    return std::sqrt(1.2 * 1.2 - 2 * kEarth * 3 / 1.04 * lifted);
  };
  // Simpson's rule, of which this many parts are good for 14 digits.
  constexpr int kParts = 2000;
  Real sum = 1 / speed(0) + 1 / speed(tilt);
  for (int i = 1; i < kParts; ++i) sum += (i % 2 == 1 ? 4 : 2) / speed(i * tilt / kParts);
  return std::abs(sum * tilt / (3 * kParts) - time) * speed(tilt);
}

// --- A ball with side spin that slides along a parabola, and rolls on

inline const carom::TableBall kShot{{0, 0}, {2, 0}, {-5, 2, 0}};

inline BodyId addShot(World& world) {
  return world.add({.position = {0, 5, 0.5},
                    .velocity = {2, 0, 0},
                    .angularVelocity = kShot.angularVelocity,
                    .shapes = {made(carom::Ball{0.5}, 0.3, 0)}});
}

inline Real shotError(const World& world, BodyId ball, Real time) {
  const carom::TableLaw law{.radius = 0.5, .friction = 0.3, .gravity = kEarth};
  const carom::TableBall exact = carom::rollBall(kShot, law, time);
  const Vector3 at = world.position(ball);
  const Real x = at.x() - exact.position.x(), y = at.y() - 5 - exact.position.y();
  return std::sqrt(x * x + y * y);
}

// --- A ball that falls from a metre and bounces, e = 0.8

inline BodyId addBouncing(World& world) {
  return world.add({.position = {0, -5, 1.5}, .shapes = {made(carom::Ball{0.5}, 0, 0.8)}});
}

inline Real bouncingError(const World& world, BodyId ball, Real time) {
  const Real height = carom::bounceBall({1, 0}, {0.8, kEarth}, time).height;
  return std::abs(world.position(ball).z() - 0.5 - height);
}

inline std::vector<Known> knownScenes() {
  return {{"a box tips over", addTipping, tippingError},
          {"a ball slides and rolls", addShot, shotError},
          {"a ball bounces", addBouncing, bouncingError}};
}

// Rows of contact and friction set up so far: the work of both ways to go.
inline long rowsOf(const World& world) {
  const carom::world::Counters& c = world.counters();
  return static_cast<long>(c.normalRows + c.frictionRows);
}
