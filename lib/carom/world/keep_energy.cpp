#include "carom/world/keep_energy.hpp"

#include <algorithm>
#include <cmath>

#include "carom/world/move_body.hpp"

namespace carom::world {

namespace {

// Who moves with all that holds an island sees no work done by it. Without anything that holds it
// that is who moves with the middle of its bodies.
bool findFrame(const WorldState& state, const IslandSlot& island, Vector3& frame) {
  bool known = false;
  for (const Index index : island.pairs) {
    const BodySlot& wall = state.bodies[at(state.pairs[at(index)].bodyA)];
    if (isDynamic(wall)) continue;
    if (wall.velocity.angular != Vector3::Zero()) return false;
    if (known && wall.velocity.linear != frame) return false;
    frame = wall.velocity.linear;
    known = true;
  }
  if (known) return true;
  Real mass = 0;
  Vector3 momentum = Vector3::Zero();
  for (const Index index : island.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    mass += body.weight;
    momentum += body.weight * body.velocity.linear;
  }
  frame = momentum / mass;
  return true;
}

Real motionOf(const WorldState& state, const IslandSlot& island) {
  Real sum = 0;
  for (const Index index : island.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    sum += body.weight * (body.velocity.linear - island.frame).squaredNorm() +
           turningEnergy(body, body.pose.R_WB, body.velocity.angular);
  }
  return sum / 2;
}

}  // namespace

void watchEnergy(WorldState& state, IslandSlot& island) {
  const bool turns = std::any_of(island.bodies.begin(), island.bodies.end(), [&](Index index) {
    return state.bodies[at(index)].torque != Vector3::Zero();
  });
  island.energyKept = !turns && !state.longSteps && state.settings.gyroscopic &&
                      findFrame(state, island, island.frame);
  island.lifted = 0;
  if (island.energyKept) island.motion = motionOf(state, island);
}

void payForWay(const WorldState& state, IslandSlot& island, BodySlot& body, const Vector3& way) {
  const Real length = way.norm();
  if (!island.energyKept || length <= state.settings.restTolerance) return;
  const Vector3 along = way / length;
  const Real cost = -2 * freeAcceleration(state, body).dot(way);
  if (!(cost > 0)) return;
  const Real speed = along.dot(body.velocity.linear - island.frame);
  const Real left = std::max(Real(0), speed * speed - cost);
  body.velocity.linear += (std::copysign(std::sqrt(left), speed) - speed) * along;
  island.lifted += body.weight * (cost - (speed * speed - left)) / 2;
}

void keepEnergy(WorldState& state, const IslandSlot& island, std::span<const Pose> starts,
                Real duration) {
  if (!island.energyKept) return;
  // Of the motion there was and of what gravity gives in a step. Soft steps are of the first order.
  const Real visible = island.isPile ? 0 : 1e-6;
  Real fallen = island.lifted, mass = 0;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const BodySlot& body = state.bodies[at(island.bodies[i])];
    const Vector3 way = body.position - starts[i].p_WB - duration * island.frame;
    const Real fall = body.weight * freeAcceleration(state, body).dot(way);
    // Soft steps lift what lies in something else by ways that are no motion.
    fallen += island.isPile ? std::max(Real(0), fall) : fall;
    mass += body.weight;
  }
  const Real most = island.motion + fallen;
  const Real slack = island.motion + mass * (duration * state.settings.gravity).squaredNorm();
  const Real now = motionOf(state, island);
  if (!(now > 0) || now <= most + visible * slack) return;
  ++state.counters.energiesKept;
  const Real share = std::sqrt(std::max(Real(0), most) / now);
  for (const Index index : island.bodies) {
    BodySlot& body = state.bodies[at(index)];
    dropAnchor(state, body);
    body.velocity.linear = island.frame + share * (body.velocity.linear - island.frame);
    body.velocity.angular *= share;
  }
}

}  // namespace carom::world
