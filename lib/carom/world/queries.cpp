#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "carom/core/checks.hpp"
#include "carom/detection/bounds.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/world/collide_ground.hpp"
#include "carom/world/update_contacts.hpp"
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

// A shape as the functions of chapters 3 and 7 want it: of a ground one flat triangle.
const Shape& wholeOf(const ShapeSlot& slot, Shape& thin) {
  if (!slot.data->ground) return slot.data->whole;
  flatHull(*slot.data->ground, slot.item, std::get<ConvexHull>(thin));
  return thin;
}

// Whether queries see a shape: the edges of a ground belong to its faces.
bool isSeen(const ShapeSlot& slot) {
  return slot.alive && (!slot.data->ground || slot.data->ground->isFace(slot.item));
}

// The tight box, and room for rounding.
Aabb<3> roomyBox(const WorldState& state, Index shape) {
  constexpr Real kRoom = 1e-12;  // of the largest coordinate
  Aabb<3> box = boundsOfShape(state.shapes[at(shape)], poseNow(state, shape));
  for (int k = 0; k < 3; ++k) {
    if (std::isfinite(box.low(k))) box.low(k) -= kRoom * std::abs(box.low(k));
    if (std::isfinite(box.high(k))) box.high(k) += kRoom * std::abs(box.high(k));
  }
  return box;
}

// Tells the tree where the shapes are that may have moved since the last query.
void bringUpToDate(WorldState& state) {
  AskedShapes& asked = state.asked;
  asked.counters = QueryCounters();
  if (state.time != asked.builtAt) {
    for (const Index body : state.awakeBodies) {
      for (const Index shape : state.bodies[at(body)].shapes) makeStale(state, shape);
    }
    asked.builtAt = state.time;
  }
  for (const Index shape : asked.stale) {
    ShapeSlot& slot = state.shapes[at(shape)];
    slot.isStale = false;
    const bool wanted = isSeen(slot);
    if (wanted && slot.isAsked) {
      asked.tree.move(shape, roomyBox(state, shape));
    } else if (wanted) {
      asked.tree.insert(shape, roomyBox(state, shape));
    } else if (slot.isAsked) {
      asked.tree.remove(shape);
    }
    slot.isAsked = wanted;
  }
  asked.counters.shapesUpdated = static_cast<std::int64_t>(asked.stale.size());
  asked.stale.clear();
  if (2 * asked.tree.unsettled() > asked.tree.size()) asked.tree.rebuild();
}

// The plain version, for those who want to compare: every shape.
bool looksAtAll(const WorldState& state) {
  return state.settings.pairFinding == PairFinding::allPairs;
}

template <class Visit>
void forEachShape(WorldState& state, Visit&& visit) {
  for (std::size_t i = 0; i < state.shapes.size(); ++i) {
    if (isSeen(state.shapes[i])) visit(static_cast<Index>(i));
  }
}

// Shapes that a box may meet on its way: visit() returns how much of the way still counts.
template <class Visit>
void forEachOnWay(WorldState& state, const Aabb<3>& box, const Vector3& way, std::uint32_t mask,
                  Visit&& visit) {
  bringUpToDate(state);
  const auto ask = [&](Index shape) {
    if (!isMeant(state, shape, mask)) return Real(1);
    ++state.asked.counters.shapesTested;
    return static_cast<Real>(visit(shape, poseNow(state, shape)));
  };
  if (looksAtAll(state)) {
    forEachShape(state, ask);
  } else {
    state.asked.counters.nodesVisited += state.asked.tree.sweep(box, way, ask);
  }
}

}  // namespace

std::optional<QueryHit> World::rayCast(const Ray& ray, std::uint32_t mask) const {
  WorldState& state = *state_;
  // Checks the ray, also where there is nothing to hit.
  static_cast<void>(castRay(Shape(Ball{1}), Pose{}, ray));
  // A ray without end has one here that is far behind everything.
  constexpr Real kFar = 1e60;
  const Real reach = std::min(ray.reach, kFar / ray.direction.cwiseAbs().maxCoeff());
  std::optional<QueryHit> best;
  forEachOnWay(state, {ray.origin, ray.origin}, reach * ray.direction, mask,
               [&](Index shape, const Pose& pose) -> Real {
                 const ShapeSlot& slot = state.shapes[at(shape)];
                 const RayHit hit = slot.data->ground
                                        ? castRayAtFace(*slot.data->ground, slot.item, pose, ray)
                                        : castRay(slot.data->whole, pose, ray);
                 if (hit.hit) {
                   keepBetter(best, {idOfBody(state, slot.body), idOfShape(state, shape), hit.t,
                                     hit.point, hit.normal});
                 }
                 // What is as near but for rounding may have a smaller id.
                 constexpr Real kTie = 1 + 1e-12;
                 return best && reach > 0 ? std::min(Real(1), kTie * best->time / reach) : 1;
               });
  return best;
}

std::vector<BodyId> World::overlap(const Shape& shape, const Pose& pose, std::uint32_t mask) const {
  carom::requireUsable(shape);
  carom::requireUsable(pose, "pose");
  WorldState& state = *state_;
  bringUpToDate(state);
  std::vector<BodyId> bodies;
  Shape thin = ConvexHull();
  const Aabb<3> box = boundsOf(shape, pose);
  const auto ask = [&](Index index) {
    const ShapeSlot& slot = state.shapes[at(index)];
    if (!isMeant(state, index, mask)) return;
    const Pose other = poseNow(state, index);
    if (!meets(boundsOfShape(slot, other), box)) return;
    ++state.asked.counters.shapesTested;
    if (signedDistance(shape, pose, wholeOf(slot, thin), other).separation > 0) return;
    bodies.push_back(idOfBody(state, slot.body));
  };
  if (looksAtAll(state)) {
    forEachShape(state, ask);
  } else {
    state.asked.counters.nodesVisited += state.asked.tree.overlap(box, ask);
  }
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
  WorldState& state = *state_;
  Sweep moving;
  moving.start = pose;
  moving.velocity = velocity;
  std::optional<QueryHit> best;
  Shape thin = ConvexHull();
  forEachOnWay(state, boundsOf(shape, pose), duration * velocity, mask,
               [&](Index index, const Pose& other) -> Real {
                 const ShapeSlot& slot = state.shapes[at(index)];
                 Sweep resting;
                 resting.start = other;
                 const TimeOfImpact hit =
                     firstContact(wholeOf(slot, thin), resting, shape, moving, duration);
                 if (hit.status != ImpactStatus::kNoHit) {
                   keepBetter(best, {idOfBody(state, slot.body), idOfShape(state, index), hit.time,
                                     hit.point, hit.normal});
                 }
                 // A contact is found by a hair too early, and not by the same for all.
                 constexpr Real kTie = 1 + 1e-9;
                 return best && duration > 0 ? std::min(Real(1), kTie * best->time / duration) : 1;
               });
  return best;
}

}  // namespace carom::world
