#include <algorithm>
#include <optional>
#include <vector>

#include "carom/core/checks.hpp"
#include "carom/detection/bounds.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/world/world.hpp"
#include "carom/world/world_state.hpp"

namespace carom::world {

namespace {

// The best hit so far, and of equally good ones that with the smaller shape number.
void keepBetter(std::optional<QueryHit>& best, const QueryHit& hit) {
  if (!best || hit.time < best->time || (hit.time == best->time && hit.shape < best->shape)) {
    best = hit;
  }
}

bool isMeant(const WorldState& state, Index shape, std::uint32_t mask) {
  return (state.shapes[at(shape)].filter.group & mask) != 0;
}

Pose poseNow(const WorldState& state, Index shape) {
  const ShapeSlot& slot = state.shapes[at(shape)];
  return poseOfShape(state.bodies[at(slot.body)], slot);
}

// Visits all shapes that are alive: the trees know those of the last step only, and what was added
// or moved since then must be found, too. The tight box is the first test.
template <class Visit>
void forEachNear(const WorldState& state, const Aabb<3>& box, std::uint32_t mask, Visit&& visit) {
  for (std::size_t i = 0; i < state.shapes.size(); ++i) {
    const Index shape = static_cast<Index>(i);
    if (!state.shapes[i].alive || !isMeant(state, shape, mask)) continue;
    const Pose pose = poseNow(state, shape);
    if (meets(boundsOf(state.shapes[i].data->whole, pose), box)) visit(shape, pose);
  }
}

}  // namespace

std::optional<QueryHit> World::rayCast(const Ray& ray, std::uint32_t mask) const {
  const WorldState& state = *state_;
  // Checks the ray, also where there is nothing to hit.
  static_cast<void>(castRay(Shape(Ball{1}), Pose{}, ray));
  std::optional<QueryHit> best;
  for (std::size_t i = 0; i < state.shapes.size(); ++i) {
    const Index shape = static_cast<Index>(i);
    if (!state.shapes[i].alive || !isMeant(state, shape, mask)) continue;
    const RayHit hit = castRay(state.shapes[i].data->whole, poseNow(state, shape), ray);
    if (!hit.hit) continue;
    keepBetter(best, {idOfBody(state, state.shapes[i].body), idOfShape(state, shape), hit.t,
                      hit.point, hit.normal});
  }
  return best;
}

std::vector<BodyId> World::overlap(const Shape& shape, const Pose& pose, std::uint32_t mask) const {
  carom::requireUsable(shape);
  carom::requireUsable(pose, "pose");
  const WorldState& state = *state_;
  std::vector<BodyId> bodies;
  forEachNear(state, boundsOf(shape, pose), mask, [&](Index index, const Pose& other) {
    const Shape& theirs = state.shapes[at(index)].data->whole;
    if (signedDistance(shape, pose, theirs, other).separation > 0) return;
    bodies.push_back(idOfBody(state, state.shapes[at(index)].body));
  });
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

std::optional<QueryHit> World::sweep(const Shape& shape, const Pose& pose, const Vector3& velocity,
                                     Real duration, std::uint32_t mask) const {
  carom::requireUsable(shape);
  carom::requireUsable(pose, "pose");
  requireFinite(velocity, "velocity");
  requireNonNegative(duration, "duration");
  if (std::holds_alternative<HalfSpace>(shape)) {
    throw InvalidInput("sweep: a half-space cannot be swept: it has no end");
  }
  const WorldState& state = *state_;
  const Aabb<3> start = boundsOf(shape, pose);
  const Vector3 way = duration * velocity;
  const Aabb<3> all = joined(start, Aabb<3>{start.low + way, start.high + way});
  Sweep moving;
  moving.start = pose;
  moving.velocity = velocity;
  std::optional<QueryHit> best;
  forEachNear(state, all, mask, [&](Index index, const Pose& other) {
    Sweep resting;
    resting.start = other;
    const TimeOfImpact hit =
        firstContact(state.shapes[at(index)].data->whole, resting, shape, moving, duration);
    if (hit.status == ImpactStatus::kNoHit) return;
    keepBetter(best, {idOfBody(state, state.shapes[at(index)].body), idOfShape(state, index),
                      hit.time, hit.point, hit.normal});
  });
  return best;
}

}  // namespace carom::world
