#include "carom/world/stay_in_room.hpp"

#include <algorithm>
#include <limits>

#include "carom/core/cross.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/world/collide_ground.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/next_contact.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

// Whether two shapes meet until `end`, the first of which is a dynamic body's at its own time.
bool meetsOnWay(WorldState& state, const ShapeSlot& shape, const ShapeSlot& other, Real end) {
  if (other.data->ground) return true;  // nobody looks at its triangles here
  const BodySlot &body = state.bodies[at(shape.body)], &wall = state.bodies[at(other.body)];
  const Sweep mine = sweepOf(body, bodyAt(state, shape.body, body.clock), shape);
  const Sweep its = sweepOf(wall, bodyAt(state, other.body, body.clock), other);
  const Real duration = end - body.clock;
  return firstContact(other.data->whole, its, shape.data->whole, mine, duration).status !=
         ImpactStatus::kNoHit;
}

// Whether the shape meets something on its way that cannot be moved and whose contact nobody has
// looked for: they are no pair, or one whose boxes have not met in this step. The broad phase keeps
// such pairs, and no island has them.
bool meetsStranger(WorldState& state, Index index, const Aabb<3>& way, Real end) {
  const ShapeSlot& shape = state.shapes[at(index)];
  const PairCache& pairs = state.broadPhase.pairs();
  bool found = false;
  const auto look = [&](std::int32_t other) {
    // Where all pairs are compared every box is everywhere.
    if (found || !meets(state.shapes[at(other)].swept, way)) return;
    if (!mayMeet(state, index, other)) return;
    const Index pair = pairs.find(index, other);
    const bool isStrange = pair == kNone || state.pairs[at(pair)].island == kNone;
    found = isStrange && meetsOnWay(state, shape, state.shapes[at(other)], end);
  };
  if (holds(shape.swept, way)) return false;
  state.broadPhase.immovableTree().overlap(way, look);
  state.broadPhase.overlapMoving(way, [&](std::int32_t other) {
    const BodySlot& body = state.bodies[at(state.shapes[at(other)].body)];
    if (body.kind == BodyKind::kinematic) look(other);
  });
  return found;
}

// Whether a body is within the boxes in which it was expected.
bool isInside(WorldState& state, Index index, Real time) {
  const BodyState then = bodyAt(state, index, time);
  for (const Index number : state.bodies[at(index)].shapes) {
    const ShapeSlot& shape = state.shapes[at(number)];
    if (!holds(shape.swept, boundsOfShape(shape, poseOfShape(then, shape)))) return false;
  }
  return true;
}

}  // namespace

void stayInRoom(WorldState& state, Index index, Real end) {
  BodySlot& body = state.bodies[at(index)];
  const Real duration = end - body.clock;
  // In long steps boxes have all the room that is needed, or the step is taken back.
  if (state.longSteps || !(duration > 0)) return;
  // The middle stays between where it is and where it goes, with and without acceleration.
  const Vector3 straight = body.position + duration * body.velocity.linear;
  const Vector3 bent = duration * duration * body.acceleration;
  const Vector3 size = Vector3::Constant(body.reach);
  Aabb<3> box;
  for (const Vector3& place : {body.position, straight, Vector3(straight + bent)}) {
    box.low = box.low.cwiseMin(place - size);
    box.high = box.high.cwiseMax(place + size);
  }
  bool mayPass = false;
  for (const Index shape : body.shapes) mayPass = mayPass || meetsStranger(state, shape, box, end);
  if (!mayPass || isInside(state, index, end)) return;
  Real low = body.clock, high = end;
  constexpr int kHalvings = 20;
  for (int i = 0; i < kHalvings; ++i) {
    const Real middle = (low + high) / 2;
    (isInside(state, index, middle) ? low : high) = middle;
  }
  moveBody(state, index, low);
  body.clock = end;
}

void rememberMiddles(WorldState& state, std::span<const Index> bodies) {
  state.work.middles.clear();
  for (const Index index : bodies) state.work.middles.push_back(state.bodies[at(index)].position);
}

namespace {

// How far a middle has to be lifted to be in front of a wall again.
struct Lift {
  Vector3 normal = Vector3::Zero();  // of the wall [1]
  Real way = 0;                      // none: it is in front [m]
};

// Through a face of a sheet, from its front. `from` is where the middle was, as the sheet goes.
Lift liftOverFace(const WorldState& state, const PairSlot& pair, const Pose& G,
                  const Vector3& from) {
  const ShapeSlot& shape = state.shapes[at(pair.shapeA)];
  const Ground& ground = *shape.data->ground;
  const GroundFace& face = ground.faces[at(shape.item)];
  const Vector3& to = state.bodies[at(pair.bodyB)].position;
  const Vector3 normal = G.R_WB * face.normal;
  const Real height = normal.dot(to - pointToWorld(G, ground.vertices[at(face.corners[0])]));
  if (height >= 0 || normal.dot(to - from) >= 0) return {};
  if (!castRayAtFace(ground, shape.item, G, {from, to - from, 1}).hit) return {};
  return {normal, touchGap(state, pair) - height};
}

// Deeper into a solid than it was.
Lift liftOutOf(const ShapeSlot& shape, const Pose& A, const Vector3& from, const Vector3& to) {
  const auto depthAt = [&](const Vector3& middle, Vector3* normal) {
    const Separation found =
        signedDistance(shape.data->whole, A, Ball{0}, {Matrix3::Identity(), middle});
    if (normal != nullptr) *normal = found.normal;
    return std::max(Real(0), -found.separation);
  };
  Lift lift;
  const Real depth = depthAt(to, &lift.normal);
  if (depth > 0) lift.way = depth - depthAt(from, nullptr);
  return lift;
}

// How high the middle of the body is over the contacts of a pair, all of them as they were made.
Real heightOver(const PairSlot& pair, const Vector3& middle) {
  Real least = std::numeric_limits<Real>::infinity();
  for (int i = 0; i < pair.manifold.count; ++i) {
    const ManifoldPoint& point = pair.manifold.points[at(i)];
    const Real height = pair.manifold.normal.dot(middle - point.position) + point.separation / 2;
    least = std::min(least, height);
  }
  return least;
}

// Returns whether the body of the pair had to be held.
bool holdMiddle(WorldState& state, const PairSlot& pair, const StepSpan& span, bool followed) {
  if (isDynamic(state.bodies[at(pair.bodyA)])) return false;
  const ShapeSlot& shape = state.shapes[at(pair.shapeA)];
  const bool isGround = shape.data->ground != nullptr;
  BodySlot& body = state.bodies[at(pair.bodyB)];
  if (isGround ? !shape.data->ground->isFace(shape.item) : followed) return false;
  if (body.shapes.size() != 1) return false;
  const BodyState then = bodyAt(state, pair.bodyA, span.start),
                  now = bodyAt(state, pair.bodyA, span.end);
  const Pose before = poseOfShape(then, shape);
  const Pose after = poseOfShape(now, shape);
  const Vector3 from = pointToWorld(after, pointToBody(before, state.work.middles[at(body.local)]));
  Lift lift;
  if (isGround) {
    lift = liftOverFace(state, pair, after, from);
  } else {
    // Who goes a short way is stopped by his contacts, unless others press him in.
    constexpr Real kFar = 0.125;
    const Real far = kFar * body.reach;
    const bool isShort = (body.position - from).norm() <= far;
    const Vector3 middle = pointToWorld(before, pointToBody(after, body.position));
    if (isShort && heightOver(pair, middle) > far) return false;
    lift = liftOutOf(shape, after, from, body.position);
    if (lift.way > 0) lift.way += touchGap(state, pair);
  }
  if (!(lift.way > 0)) return false;
  body.position += lift.way * lift.normal;
  body.pose.p_WB = body.position;
  const Velocity& wall = now.velocity;
  const Vector3 against = body.velocity.linear - wall.linear -
                          cross(wall.angular, Vector3(body.position - now.position));
  const Real speed = lift.normal.dot(against);
  if (speed < 0) body.velocity.linear -= speed * lift.normal;
  return true;
}

}  // namespace

void holdMiddles(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                 const StepSpan& span, bool followed) {
  // Long steps are taken back if they are wrong.
  if (state.longSteps || !state.settings.continuous) return;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    state.bodies[at(bodies[i])].local = static_cast<Index>(i);
  }
  // What is lifted out of one wall may be behind the next.
  constexpr int kRounds = 3;
  bool held = true;
  for (int round = 0; round < kRounds && held; ++round) {
    held = false;
    for (const Index pair : pairs) {
      held = holdMiddle(state, state.pairs[at(pair)], span, followed) || held;
    }
  }
}

}  // namespace carom::world
