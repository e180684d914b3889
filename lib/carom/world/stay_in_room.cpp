#include "carom/world/stay_in_room.hpp"

#include "carom/world/move_body.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

// Whether the shape may meet something on its way that cannot be moved and whose contact nobody has
// looked for: they are no pair, or one whose boxes have not met in this step. The broad phase keeps
// such pairs, and no island has them.
bool meetsStranger(const WorldState& state, Index index, const Aabb<3>& way) {
  const ShapeSlot& shape = state.shapes[at(index)];
  const PairCache& pairs = state.broadPhase.pairs();
  bool found = false;
  const auto look = [&](std::int32_t other) {
    // Where all pairs are compared every box is everywhere.
    if (found || !meets(state.shapes[at(other)].swept, way)) return;
    if (!mayMeet(state, index, other)) return;
    const Index pair = pairs.find(index, other);
    found = pair == kNone || state.pairs[at(pair)].island == kNone;
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
  const Pose pose = poseOf(then.orientation, then.position);
  for (const Index number : state.bodies[at(index)].shapes) {
    const ShapeSlot& shape = state.shapes[at(number)];
    if (!holds(shape.swept, boundsOfShape(shape, placed(pose, shape)))) return false;
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
  for (const Index shape : body.shapes) mayPass = mayPass || meetsStranger(state, shape, box);
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

}  // namespace carom::world
