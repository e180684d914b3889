#include "carom/world/world.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <string>
#include <utility>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/detection/limits.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom/rotation/renormalize.hpp"
#include "carom/world/add_body.hpp"
#include "carom/world/advance_world.hpp"
#include "carom/world/islands.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/step_world.hpp"
#include "carom/world/update_contacts.hpp"
#include "carom/world/world_state.hpp"

namespace carom::world {

namespace {

Index indexOf(const WorldState& state, BodyId id) {
  const bool known = id.index < state.bodies.size() && !id.isNull() &&
                     state.bodies[id.index].alive &&
                     state.bodies[id.index].generation == id.generation;
  if (!known) {
    reject("body id",
           "(index " + std::to_string(id.index) + ", generation " + std::to_string(id.generation) +
               ")",
           "names no body of this world: it is null, or its body was removed");
  }
  return static_cast<Index>(id.index);
}

const BodySlot& slotOf(const WorldState& state, BodyId id) {
  return state.bodies[at(indexOf(state, id))];
}

Index dynamicOf(const WorldState& state, BodyId id, const char* what) {
  const Index index = indexOf(state, id);
  if (!isDynamic(state.bodies[at(index)])) {
    throw InvalidInput(std::string(what) + ": the body is not dynamic");
  }
  return index;
}

Quaternion orientationOf(const BodySlot& body) {
  const Quaternion& t = body.turned;
  if (t.x == 0 && t.y == 0 && t.z == 0) return body.orientation;
  return renormalize(hamiltonProduct(body.orientation, conjugate(t)));
}

}  // namespace

World::World(const WorldSettings& settings) : state_(std::make_unique<WorldState>()) {
  requireUsable(settings);
  state_->settings = settings;
}

World::~World() = default;
World::World(World&& other) noexcept = default;
World& World::operator=(World&& other) noexcept = default;

const WorldSettings& World::settings() const {
  return state_->settings;
}

void World::change(const WorldSettings& settings) {
  requireUsable(settings);
  state_->settings = settings;
  for (std::size_t i = 0; i < state_->islands.size(); ++i) {
    state_->islands[i].still = false;
    if (state_->islands[i].alive) wakeIsland(*state_, static_cast<Index>(i));
  }
}

BodyId World::add(const BodyDescription& description) {
  return addBody(*state_, description);
}

void World::remove(BodyId body) {
  removeBody(*state_, indexOf(*state_, body));
}

bool World::contains(BodyId id) const {
  return id.index < state_->bodies.size() && state_->bodies[id.index].alive &&
         state_->bodies[id.index].generation == id.generation;
}

std::vector<BodyId> World::bodies() const {
  std::vector<BodyId> ids;
  for (std::size_t i = 0; i < state_->bodies.size(); ++i) {
    if (state_->bodies[i].alive) ids.push_back(idOfBody(*state_, static_cast<Index>(i)));
  }
  return ids;
}

int World::bodyCount() const {
  return state_->bodyCount;
}

std::vector<ShapeId> World::shapesOf(BodyId body) const {
  std::vector<ShapeId> ids;
  for (const Index shape : slotOf(*state_, body).shapes) ids.push_back(idOfShape(*state_, shape));
  return ids;
}

Vector3 World::position(BodyId id) const {
  const BodySlot& body = slotOf(*state_, id);
  if (body.centre == Vector3::Zero()) return body.position;
  return body.position - quaternionToMatrix(orientationOf(body)) * body.centre;
}

Quaternion World::orientation(BodyId id) const {
  return orientationOf(slotOf(*state_, id));
}

Vector3 World::centre(BodyId id) const {
  return slotOf(*state_, id).position;
}

Vector3 World::velocity(BodyId id) const {
  return slotOf(*state_, id).velocity.linear;
}

Vector3 World::angularVelocity(BodyId id) const {
  return slotOf(*state_, id).velocity.angular;
}

Real World::mass(BodyId id) const {
  const BodySlot& body = slotOf(*state_, id);
  return isDynamic(body) ? body.weight : std::numeric_limits<Real>::infinity();
}

Matrix3 World::inertia(BodyId id) const {
  const BodySlot& body = slotOf(*state_, id);
  const Matrix3& R = body.pose.R_WB;
  const Matrix3 scaled = R * body.moments.asDiagonal();
  return scaled * R.transpose();
}

void World::place(BodyId id, const Vector3& position, const Quaternion& orientation) {
  const Index index = indexOf(*state_, id);
  requireCoordinates(position, "position");
  const Quaternion q_WB = requireUnit(orientation, "orientation");
  BodySlot& body = state_->bodies[at(index)];
  wakeBody(*state_, index);
  for (const Index shape : body.shapes) {
    state_->broadPhase.pairs().forEachOf(shape, [&](std::int32_t pair, std::int32_t) {
      wakeBody(*state_, state_->pairs[at(pair)].bodyA);
      wakeBody(*state_, state_->pairs[at(pair)].bodyB);
    });
  }
  dropAnchor(*state_, body);
  body.orientation = renormalize(hamiltonProduct(q_WB, body.turned));
  body.position = position + quaternionToMatrix(q_WB) * body.centre;
  body.lost = Vector3::Zero();
  refreshPose(body);
  moveBoxes(*state_, index, 0);
  for (const Index shape : body.shapes) makeStale(*state_, shape);
}

void World::setVelocity(BodyId id, const Vector3& velocity, const Vector3& angularVelocity) {
  const Index index = indexOf(*state_, id);
  BodySlot& body = state_->bodies[at(index)];
  if (body.kind == BodyKind::immovable) throw InvalidInput("setVelocity: the body is immovable");
  requireFinite(velocity, "velocity");
  requireFinite(angularVelocity, "angularVelocity");
  for (const Index shape : body.shapes) {
    if (state_->shapes[at(shape)].data->isHalfSpace && angularVelocity != Vector3::Zero()) {
      reject("angularVelocity", toText(angularVelocity), "must be zero for a half-space");
    }
  }
  wakeBody(*state_, index);
  if (body.kind == BodyKind::kinematic) {
    for (const Index shape : body.shapes) {
      state_->broadPhase.pairs().forEachOf(shape, [&](std::int32_t pair, std::int32_t) {
        wakeBody(*state_, state_->pairs[at(pair)].bodyB);
      });
    }
  }
  dropAnchor(*state_, body);
  body.velocity = {velocity, angularVelocity};
}

void World::push(BodyId id, const Vector3& impulse, const Vector3& point) {
  const Index index = dynamicOf(*state_, id, "push");
  requireFinite(impulse, "impulse");
  requireFinite(point, "point");
  BodySlot& body = state_->bodies[at(index)];
  wakeBody(*state_, index);
  body.velocity.linear += body.mass.inverseMass * impulse;
  const Vector3 torque = cross(Vector3(point - body.position), impulse);
  if (torque == Vector3::Zero()) return;
  dropAnchor(*state_, body);
  body.velocity.angular += body.mass.inverseInertia * torque;
}

void World::setForce(BodyId id, const Vector3& force, const Vector3& torque) {
  const Index index = dynamicOf(*state_, id, "setForce");
  requireFinite(force, "force");
  requireFinite(torque, "torque");
  BodySlot& body = state_->bodies[at(index)];
  wakeBody(*state_, index);
  dropAnchor(*state_, body);
  body.force = force;
  body.torque = torque;
}

void World::wake(BodyId id) {
  wakeBody(*state_, indexOf(*state_, id));
}

bool World::asleep(BodyId id) const {
  return slotOf(*state_, id).asleep;
}

void World::step(Real dt) {
  requirePositive(dt, "dt");
  stepWorld(*state_, dt);
}

void World::advance(Real duration, Real tolerance) {
  requirePositive(duration, "duration");
  requirePositive(tolerance, "tolerance");
  advanceWorld(*state_, duration, tolerance);
}

Real World::time() const {
  return state_->time;
}

const Counters& World::counters() const {
  return state_->counters;
}

const QueryCounters& World::queryCounters() const {
  return state_->asked.counters;
}

Events World::events() const {
  return {state_->begun, state_->ended, state_->impacts};
}

std::vector<TouchingPair> World::touching() const {
  std::vector<Index> pairs;
  for (std::size_t i = 0; i < state_->pairs.size(); ++i) {
    if (state_->pairs[i].alive && state_->pairs[i].touches) {
      pairs.push_back(static_cast<Index>(i));
    }
  }
  std::sort(pairs.begin(), pairs.end(), [&](Index p, Index q) {
    return pairOf(state_->pairs[at(p)].shapeA, state_->pairs[at(p)].shapeB) <
           pairOf(state_->pairs[at(q)].shapeA, state_->pairs[at(q)].shapeB);
  });
  std::vector<TouchingPair> touching;
  for (const Index index : pairs) {
    const PairSlot& pair = state_->pairs[at(index)];
    TouchingPair one;
    one.bodyA = idOfBody(*state_, pair.bodyA);
    one.bodyB = idOfBody(*state_, pair.bodyB);
    one.normal = pair.manifold.normal;
    one.points = pair.manifold.count;
    one.separation = std::numeric_limits<Real>::infinity();
    for (int i = 0; i < pair.manifold.count; ++i) {
      one.separation = std::min(one.separation, pair.manifold.points[at(i)].separation);
      one.normalForce += pair.force[at(i)];
    }
    touching.push_back(one);
  }
  return touching;
}

Real World::energy() const {
  Real sum = 0;
  for (const BodySlot& body : state_->bodies) {
    if (!body.alive || !isDynamic(body)) continue;
    sum += body.weight * (body.velocity.linear.squaredNorm() / 2 -
                          state_->settings.gravity.dot(body.position)) +
           world::turningEnergy(body, body.pose.R_WB, body.velocity.angular) / 2;
  }
  return sum;
}

Vector3 World::momentum() const {
  Vector3 sum = Vector3::Zero();
  for (const BodySlot& body : state_->bodies) {
    if (body.alive && isDynamic(body)) sum += body.weight * body.velocity.linear;
  }
  return sum;
}

Vector3 World::angularMomentum() const {
  Vector3 sum = Vector3::Zero();
  for (const BodySlot& body : state_->bodies) {
    if (!body.alive || !isDynamic(body)) continue;
    const Matrix3& R = body.pose.R_WB;
    sum += body.weight * cross(body.position, body.velocity.linear) +
           R * body.moments.cwiseProduct(R.transpose() * body.velocity.angular);
  }
  return sum;
}

Snapshot World::save() const {
  Snapshot snapshot;
  snapshot.state_ = std::make_shared<const WorldState>(*state_);
  return snapshot;
}

void World::restore(const Snapshot& snapshot) {
  if (!snapshot.state_) throw InvalidInput("restore: the snapshot is empty");
  *state_ = *snapshot.state_;
}

std::uint64_t World::hash() const {
  // Each body's numbers are stirred into one (SplitMix64), and these are added: sums do not care
  // for an order.
  const auto stir = [](std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  };
  std::uint64_t sum = 0;
  for (const BodySlot& body : state_->bodies) {
    if (!body.alive) continue;
    std::uint64_t one = 0x9E3779B97F4A7C15u;
    const auto take = [&](Real value) {
      one = stir(one + std::bit_cast<std::uint64_t>(value + 0.0));  // one zero only
    };
    for (const Vector3* v : {&body.position, &body.velocity.linear, &body.velocity.angular}) {
      for (int k = 0; k < 3; ++k) take((*v)[k]);
    }
    for (const Real part :
         {body.orientation.w, body.orientation.x, body.orientation.y, body.orientation.z}) {
      take(part);
    }
    sum += one;
  }
  return sum;
}

}  // namespace carom::world
