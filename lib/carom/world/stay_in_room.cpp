#include "carom/world/stay_in_room.hpp"

#include <algorithm>

#include "carom/core/cross.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/world/collide_ground.hpp"
#include "carom/world/keep_energy.hpp"
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
  // To ask those that may move may bring a whole tree up to date.
  if (found || state.kinematicCount == 0) return found;
  state.broadPhase.overlapMoving(way, [&](std::int32_t other) {
    const BodySlot& body = state.bodies[at(state.shapes[at(other)].body)];
    if (body.kind == BodyKind::kinematic) look(other);
  });
  return found;
}

// Whether a body is within the boxes in which it was expected.
bool isInside(WorldState& state, Index index, Real time) {
  const BodyState then = bodyAt(state, index, time);
  const BodySlot& body = state.bodies[at(index)];
  for (const Index number : body.shapes) {
    const ShapeSlot& shape = state.shapes[at(number)];
    if (!holds(shape.swept, boundsOfShape(shape, poseOfShape(body, then, shape)))) return false;
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

void rememberStarts(WorldState& state, std::span<const Index> bodies) {
  state.work.starts.clear();
  for (const Index index : bodies) state.work.starts.push_back(state.bodies[at(index)].pose);
}

namespace {

// How far a middle has to be moved to be in front of a wall again, and its way so far.
struct Lift {
  Vector3 normal = Vector3::Zero();  // of the wall [1]
  Real way = 0;                      // none: it is in front [m]
  Vector3 from = Vector3::Zero();    // where it would be, had it gone with the wall [m, world]
  Vector3 to = Vector3::Zero();      // where it is [m, world]
};

// Through a face of a sheet, from its front.
void liftOverFace(const WorldState& state, const PairSlot& pair, const Pose& G, Lift& lift) {
  const ShapeSlot& shape = state.shapes[at(pair.shapeA)];
  const Ground& ground = *shape.data->ground;
  const GroundFace& face = ground.faces[at(shape.item)];
  const Vector3 normal = G.R_WB * face.normal, way = lift.to - lift.from;
  const Real height = normal.dot(lift.to - pointToWorld(G, ground.vertices[at(face.corners[0])]));
  if (height >= 0 || normal.dot(way) >= 0) return;
  if (!castRayAtFace(ground, shape.item, G, {lift.from, way, 1}).hit) return;
  lift.normal = normal;
  lift.way = touchGap(state, pair) - height;
}

// Deeper into a solid than it was.
void liftOutOf(const WorldState& state, const PairSlot& pair, const Pose& A, Lift& lift) {
  const ShapeSlot& shape = state.shapes[at(pair.shapeA)];
  if (!holds(shape.swept, {lift.to, lift.to})) return;
  const auto distanceAt = [&](const Vector3& middle) {
    return signedDistance(shape.data->whole, A, Ball{0}, {Matrix3::Identity(), middle});
  };
  const Separation now = distanceAt(lift.to);
  if (now.separation >= 0) return;
  const Real before = std::min(Real(0), distanceAt(lift.from).separation);
  if (now.separation >= before) return;
  lift.normal = now.normal;
  lift.way = before - now.separation + touchGap(state, pair);
}

// What of the body of a pair has gone behind the wall of it.
Lift liftOf(WorldState& state, const PairSlot& pair, const StepSpan& span) {
  const BodySlot &a = state.bodies[at(pair.bodyA)], &b = state.bodies[at(pair.bodyB)];
  if (isDynamic(a)) return {};
  const ShapeSlot &wall = state.shapes[at(pair.shapeA)], &shape = state.shapes[at(pair.shapeB)];
  const bool isGround = wall.data->ground != nullptr;
  if (isGround && !wall.data->ground->isFace(wall.item)) return {};
  const Pose& start = state.work.starts[at(b.local)];
  Lift lift;
  lift.from = pointToWorld(placed(start, shape), shape.data->middle);
  lift.to = pointToWorld(poseOfShape(b, shape), shape.data->middle);
  Pose A = poseOfShape(a, wall);
  if (a.kind == BodyKind::kinematic) {
    const Vector3 own =
        pointToBody(poseOfShape(a, bodyAt(state, pair.bodyA, span.start), wall), lift.from);
    A = poseOfShape(a, bodyAt(state, pair.bodyA, span.end), wall);
    lift.from = pointToWorld(A, own);
  }
  if (isGround) {
    liftOverFace(state, pair, A, lift);
  } else {
    liftOutOf(state, pair, A, lift);
  }
  return lift;
}

// Returns whether the body of the pair had to be held.
bool holdMiddle(WorldState& state, const PairSlot& pair, const StepSpan& span) {
  const Lift lift = liftOf(state, pair, span);
  if (!(lift.way > 0)) return false;
  BodySlot& body = state.bodies[at(pair.bodyB)];
  const BodyState wall = bodyAt(state, pair.bodyA, span.end);
  const Vector3 way = lift.way * lift.normal;
  body.position += way;
  body.pose.p_WB = body.position;
  payForWay(state, state.islands[at(body.island)], body, way);
  const Vector3 against = body.velocity.linear - wall.velocity.linear -
                          cross(wall.velocity.angular, Vector3(body.position - wall.position));
  const Real speed = lift.normal.dot(against);
  if (speed < 0) body.velocity.linear -= speed * lift.normal;
  return true;
}

}  // namespace

void holdMiddles(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                 const StepSpan& span) {
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
    for (const Index pair : pairs) held = holdMiddle(state, state.pairs[at(pair)], span) || held;
  }
}

}  // namespace carom::world
