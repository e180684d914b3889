#include "planar_world.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"
#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/contact_matrix.hpp"
#include "carom/impulse/friction_impulse.hpp"
#include "carom/impulse/impulse_2d.hpp"
#include "carom/impulse/planar_to_spatial.hpp"
#include "carom/impulse/simultaneous_impacts.hpp"
#include "planar_touches.hpp"

namespace carom {

namespace {

constexpr int kMostMoments = 10000;  // of impact in one step; then the rest of it is lost
constexpr Real kSlow = 4;   // steps of gravity: slower than that nothing bounces, or it never rests
constexpr int kRounds = 4;  // friction turns bodies, which presses contacts once more

// One contact alone follows the formula of the chapter; several share their impulses out.
std::vector<Real> normalImpulses(const std::vector<PlanarBody>& bodies,
                                 const std::vector<PlanarTouch>& touches) {
  const auto body = [&](int i) { return bodies[static_cast<std::size_t>(i)]; };
  if (touches.size() == 1) {
    const PlanarTouch& t = touches.front();
    return {impulse2d(body(t.a), body(t.b), t.contact, t.law.restitution)};
  }
  std::vector<MovingBody> lifted;
  for (const PlanarBody& flat : bodies) lifted.push_back(inSpace(flat));
  std::vector<BodyContact> contacts;
  for (const PlanarTouch& t : touches) {
    contacts.push_back({t.a, t.b, inSpace(t.contact), {.restitution = t.law.restitution}});
  }
  return simultaneousImpacts(lifted, contacts).normalImpulses;
}

// The friction that goes with a normal impulse, against the slip that is left.
Vector2 frictionOf(const PlanarBody& a, const PlanarBody& b, const PlanarTouch& t,
                   Real normalImpulse) {
  const Vector2 along(t.contact.normal.y(), -t.contact.normal.x());
  if (normalImpulse == 0) return Vector2::Zero();
  const Real mass = 1 / along.dot(contactMatrix(a.mass, b.mass, t.contact) * along);
  const Vector3 u = inSpace(relativeVelocity(a, b, t.contact));
  return frictionImpulse(u, inSpace(t.contact.normal), normalImpulse, t.law.friction, mass)
      .head<2>();
}

// Changes the velocities of all that touch and approach; tells whether anything did.
bool resolve(PlanarWorld& world, std::vector<PlanarTouch>& touches, Real dt) {
  std::vector<PlanarBody> bodies;
  for (const PlanarWorldBody& body : world.bodies) bodies.push_back(body.motion);
  bodies.emplace_back();  // the walls
  const auto body = [&](int i) -> PlanarBody& { return bodies[static_cast<std::size_t>(i)]; };
  for (PlanarTouch& t : touches) {
    const Real parting = relativeVelocity(body(t.a), body(t.b), t.contact).dot(t.contact.normal);
    if (-parting < kSlow * dt * world.gravity.norm()) t.law.restitution = 0;
  }
  bool any = false;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<Real> sizes = normalImpulses(bodies, touches);
    any = any || std::any_of(sizes.begin(), sizes.end(), [](Real size) { return size > 0; });
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const PlanarTouch& t = touches[i];
      changeVelocities(body(t.a), body(t.b), t.contact, sizes[i] * t.contact.normal);
    }
    for (std::size_t i = 0; i < touches.size(); ++i) {
      PlanarTouch& t = touches[i];
      const Vector2 friction = frictionOf(body(t.a), body(t.b), t, sizes[i]);
      changeVelocities(body(t.a), body(t.b), t.contact, friction);
      if (friction != Vector2::Zero()) t.law.restitution = 0;  // what it stirs up does not bounce
    }
  }
  for (std::size_t i = 0; i < world.bodies.size(); ++i) world.bodies[i].motion = bodies[i];
  return any;
}

}  // namespace

void step(PlanarWorld& world, Real dt) {
  requirePositive(dt, "dt");
  for (PlanarWorldBody& body : world.bodies) {
    if (body.motion.mass.inverseMass > 0) body.motion.velocity.linear += dt * world.gravity;
  }
  Real left = dt;
  for (int moment = 0; moment < kMostMoments; ++moment) {
    std::vector<PlanarTouch> touches = findTouches(world);
    if (resolve(world, touches, dt)) ++world.impacts;
    pushApart(world, touches);
    if (left <= 0) return;
    const Real time = std::min(left, timeToNextTouch(world));
    for (PlanarWorldBody& body : world.bodies) {
      body.position += time * body.motion.velocity.linear;
      body.angle += time * body.motion.velocity.angular;
    }
    left -= time;
    world.time += time;
  }
}

}  // namespace carom
