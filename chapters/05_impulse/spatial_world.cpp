#include "spatial_world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"
#include "carom/impulse/angular_acceleration.hpp"
#include "carom/impulse/apply_impulse.hpp"
#include "carom/impulse/effective_mass.hpp"
#include "carom/impulse/friction_impulse.hpp"
#include "carom/impulse/impulse_3d.hpp"
#include "carom/impulse/impulse_wall.hpp"
#include "carom/impulse/point_velocity.hpp"
#include "carom/impulse/rolling_friction.hpp"
#include "carom/impulse/simultaneous_impacts.hpp"
#include "carom/impulse/sliding_disc.hpp"
#include "carom/impulse/spinning_friction.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "spatial_touches.hpp"

namespace carom {

namespace {

constexpr Real kSlow = 4;   // steps of gravity: what hits slower does not bounce, or never rests
constexpr int kRounds = 4;  // friction turns bodies, which presses contacts once more

MovingBody inWorld(const SpatialWorldBody& body) {
  return {massInWorld(body.motion), body.motion.velocity};
}

Vector3 relativeVelocity(const SpatialTouch& t, const Contact& at) {
  return pointVelocity(t.b->motion.velocity, at.armB) -
         pointVelocity(t.a->motion.velocity, at.armA);
}

// One point alone follows the formulas of the chapter; several share their impulses out.
std::vector<Real> normalImpulses(SpatialWorld& world, const std::vector<SpatialTouch>& touches) {
  if (touches.size() == 1 && touches[0].points.size() == 1) {
    const auto& [a, b, points, separation, law] = touches[0];
    if (a->motion.inverseMass > 0) {
      return {impulse3d(inWorld(*a), inWorld(*b), points[0], law.restitution)};
    }
    return {impulseWall(inWorld(*b), points[0].armB, points[0].normal, law.restitution)};
  }
  std::vector<MovingBody> bodies;
  for (const SpatialWorldBody& body : world.bodies) bodies.push_back(inWorld(body));
  std::vector<BodyContact> contacts;
  for (const SpatialTouch& t : touches) {
    const int a = static_cast<int>(t.a - world.bodies.data());
    const int b = static_cast<int>(t.b - world.bodies.data());
    for (const Contact& point : t.points) {
      contacts.push_back({a, b, point, {.restitution = t.law.restitution}});
    }
  }
  return simultaneousImpacts(bodies, contacts).normalImpulses;
}

// Sliding, rolling and spinning friction under a pair that is pressed together.
void rub(SpatialTouch& t, const Contact& centre, Real pressed) {
  OrientedBody &a = t.a->motion, &b = t.b->motion;
  const Vector3& n = centre.normal;
  const BodyMass massA = massInWorld(a), massB = massInWorld(b);

  const Vector3 u = relativeVelocity(t, centre), slip = u - u.dot(n) * n;
  // On a disc that spins, the slips of opposite parts nearly cancel, so both frictions are weaker.
  const Real radius = std::max(t.a->patchRadius, t.b->patchRadius);
  const Real rim = radius * std::abs((b.velocity.angular - a.velocity.angular).dot(n));
  const DiscFriction share = rim > 0 ? discFriction(slip.norm() / rim) : DiscFriction{1, 0};
  if (slip.norm() > 0) {
    const Contact along{slip.normalized(), centre.armA, centre.armB};
    applyImpulse(a, centre.armA, b, centre.armB,
                 frictionImpulse(u, n, pressed, share.force * t.law.friction,
                                 effectiveMass(massA, massB, along)));
  }

  const Matrix3 inverseInertia = massA.inverseInertia + massB.inverseInertia;
  const Vector3 w = b.velocity.angular - a.velocity.angular, roll = w - w.dot(n) * n;
  Vector3 turn = Vector3::Zero();
  if (roll.norm() > 0) {
    const Vector3 axis = roll.normalized();
    turn = rollingFriction({.angularVelocity = w,
                            .normal = n,
                            .inertia = 1 / axis.dot(inverseInertia * axis),
                            .normalImpulse = pressed,
                            .arm = std::max(t.a->rollingArm, t.b->rollingArm)});
  }
  const Real spinning = n.dot(inverseInertia * n);
  if (spinning > 0) {
    turn += spinningFriction({.spin = w.dot(n),
                              .inertia = 1 / spinning,
                              .normalImpulse = pressed,
                              .friction = t.law.friction,
                              .radius = share.torque / (2.0 / 3) * radius}) *
            n;
  }
  a.velocity.angular -= massA.inverseInertia * turn;
  b.velocity.angular += massB.inverseInertia * turn;
}

// What hits slower than a few steps of gravity does not bounce.
void slowDoNotBounce(std::vector<SpatialTouch>& touches, Real slow) {
  for (SpatialTouch& t : touches) {
    Real approach = 0;
    for (const Contact& point : t.points) {
      approach = std::max(approach, -relativeVelocity(t, point).dot(point.normal));
    }
    if (approach < slow) t.law.restitution = 0;
  }
}

void resolve(SpatialWorld& world, std::vector<SpatialTouch>& touches) {
  for (int round = 0; round < kRounds && !touches.empty(); ++round) {
    const std::vector<Real> sizes = normalImpulses(world, touches);
    std::size_t next = 0;
    for (SpatialTouch& t : touches) {
      Real pressed = 0;
      Contact centre{t.points[0].normal, Vector3::Zero(), Vector3::Zero()};
      for (const Contact& point : t.points) {
        const Real size = sizes[next++];
        applyImpulse(t.a->motion, point.armA, t.b->motion, point.armB, size * point.normal);
        pressed += size;
        centre.armA += size * point.armA;
        centre.armB += size * point.armB;
      }
      if (pressed == 0) continue;
      centre.armA /= pressed, centre.armB /= pressed;
      rub(t, centre, pressed);
      t.law.restitution = 0;  // what friction stirs up does not bounce
    }
  }
}

}  // namespace

SpatialWorldBody movableBody(const Shape& shape, const MassProperties& weight,
                             const Vector3& position, const Velocity& velocity) {
  SpatialWorldBody body;
  body.shape = shape;
  body.motion = orientedBody(weight, Matrix3::Identity(), velocity);
  body.position = position;
  body.inertia = weight.inertia;
  return body;
}

void step(SpatialWorld& world, Real dt) {
  requirePositive(dt, "dt");
  // Impacts, at the speeds at which the bodies arrived.
  std::vector<SpatialTouch> touches = findTouches(world);
  slowDoNotBounce(touches, kSlow * dt * world.gravity.norm());
  resolve(world, touches);

  // Forces; what they press together does not bounce.
  for (SpatialWorldBody& body : world.bodies) {
    auto& [inverseMass, inverseInertia, R_WB, velocity] = body.motion;
    if (inverseMass == 0) continue;
    velocity.linear += dt * (world.gravity + inverseMass * dragForce(velocity.linear, body.air));
    const Vector3 w_B = R_WB.transpose() * velocity.angular;
    // Along turning axes the rate changes by the whole of Euler's equation; w x w is zero, so in
    // the world it is the same change, turned.
    velocity.angular += dt * R_WB * angularAcceleration(body.inertia, w_B, Vector3::Zero());
  }
  slowDoNotBounce(touches, std::numeric_limits<Real>::infinity());
  resolve(world, touches);

  for (SpatialWorldBody& body : world.bodies) {
    body.position += dt * body.motion.velocity.linear;
    body.orientation = integrateOrientation(body.orientation, body.motion.velocity.angular, dt);
    body.motion.R_WB = quaternionToMatrix(body.orientation);
  }
  world.time += dt;
  pushApart(world);
}

}  // namespace carom
