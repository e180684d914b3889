#pragma once
// Ways to step a body over a table with friction, from the source's to the located event.
//
// Each takes steps of one length: gravity first, then the contact, then the position. They differ
// in one line, the friction. The last does not step over the moment when sliding ends, but computes
// it.

#include <algorithm>
#include <cmath>

#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/coulomb_impact.hpp"
#include "carom/impulse/effective_mass.hpp"
#include "carom/impulse/friction_impulse.hpp"
#include "carom/impulse/roll_ball.hpp"
#include "carom/impulse/slide_block.hpp"

namespace carom::bench {

/// A body of 1 kg on the plane z = 0, its lowest point at -1 m below its centre.
struct TableScene {
  const char* name = "";
  MovingBody start;
  bool block = false;  ///< a block that cannot turn; else a solid ball of radius 1 m
  Real friction = 0.2;
  Real gravity = 9.81;
  Real duration = 2;  ///< of the motion [s]
};

/// How friction is computed in a step.
enum class FrictionMethod { source, pyramid, box, cone, exact, located };

/// The friction of a step: u is the slip, jn the normal impulse, m the mass that it moves.
inline Vector3 steppedFriction(FrictionMethod method, const Vector3& u, Real jn, Real mu, Real m) {
  switch (method) {
    case FrictionMethod::source:
      // Equation 40 with c = mu, its direction made of length one: (1 + c) and no normal impulse.
      return -(1 + mu) * m * u;
    case FrictionMethod::pyramid: {
      // |jx| + |jy| <= mu jn: the square that stands on its corner, inside the cone.
      const Real sum = m * (std::abs(u.x()) + std::abs(u.y()));
      return -m * (sum > mu * jn ? mu * jn / sum : 1) * u;
    }
    case FrictionMethod::box:
      // |jx| <= mu jn and |jy| <= mu jn: the square around the cone, what engines do.
      return {-std::clamp(m * u.x(), -mu * jn, mu * jn), -std::clamp(m * u.y(), -mu * jn, mu * jn),
              0};
    default:
      return frictionImpulse(u, {0, 0, 1}, jn, mu, m);
  }
}

/// The position of the centre at the end, after steps of equal length.
inline Vector2 slideOverTable(const TableScene& scene, FrictionMethod method, int steps) {
  const Real h = scene.duration / steps;
  if (method == FrictionMethod::located && scene.block) {
    const Slope level{.friction = scene.friction, .gravity = scene.gravity};
    SlidingBlock block{0, scene.start.velocity.linear.x()};
    for (int i = 0; i < steps; ++i) block = slideBlock(block, level, h);
    return {block.position, 0};
  }
  if (method == FrictionMethod::located) {
    const TableLaw law{.friction = scene.friction, .gravity = scene.gravity};
    const Velocity& v = scene.start.velocity;
    TableBall ball{{0, 0}, {v.linear.x(), v.linear.y()}, v.angular};
    for (int i = 0; i < steps; ++i) ball = rollBall(ball, law, h);
    return ball.position;
  }
  MovingBody table, body = scene.start;
  const Contact contact{{0, 0, 1}, {0, 0, 0}, {0, 0, -1}};
  const Real m = effectiveMass(table.mass, body.mass, {{1, 0, 0}, {0, 0, 0}, {0, 0, -1}});
  const ImpactLaw law{.friction = scene.friction};
  Vector2 position(0, 0);
  for (int i = 0; i < steps; ++i) {
    body.velocity.linear.z() -= h * scene.gravity;
    if (method == FrictionMethod::exact) {
      const Impact impact = coulombImpact(table, body, contact, law);
      changeVelocities(table, body, contact, impact.impulse);
    } else {
      const Vector3 u = relativeVelocity(table, body, contact);
      const Real jn = -u.z() / body.mass.inverseMass;
      const Vector3 slip(u.x(), u.y(), 0);
      changeVelocities(table, body, contact,
                       Vector3(0, 0, jn) + steppedFriction(method, slip, jn, scene.friction, m));
    }
    position += h * body.velocity.linear.head<2>();
  }
  return position;
}

}  // namespace carom::bench
