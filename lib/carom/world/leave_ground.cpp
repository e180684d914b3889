#include "carom/world/leave_ground.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/world/collide_ground.hpp"
#include "carom/world/contact_phase.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/next_contact.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

// Whether a ball lets go of a face where it crosses side k.
bool endsAt(const GroundFace& face, std::size_t k) {
  constexpr Real kBend = 5e-4;  // the tangent of half of a thousandth of a radian
  return face.edges[k] == EdgeKind::rim ||
         (face.edges[k] == EdgeKind::ridge && face.lean[k] > kBend);
}

// Out of a face over side k, in its plane, and where that side is along it.
struct Outwards {
  Vector3 direction;  // unit [1, world]
  Real offset;        // [m, world]
};

Outwards outwardsOf(const Ground& ground, const GroundFace& face, std::size_t k, const Pose& pose) {
  const Vector3& from = ground.vertices[at(face.corners[k])];
  const Vector3& to = ground.vertices[at(face.corners[(k + 1) % 3])];
  const Vector3 out = pose.R_WB * cross(Vector3((to - from).normalized()), face.normal);
  return {out, out.dot(pointToWorld(pose, from))};
}

// The first time after now at which place + speed t + pull t^2 / 2 rises to zero from below.
Real risingTime(Real place, Real speed, Real pull) {
  const Real root = speed * speed - 2 * pull * place;
  if (root < 0) return kNever;
  if (speed > 0) return -2 * place / (speed + std::sqrt(root));
  return pull > 0 ? (std::sqrt(root) - speed) / pull : kNever;
}

}  // namespace

void leaveGround(const WorldState& state, PairSlot& pair, const Pose& pose) {
  const ShapeSlot& shape = state.shapes[at(pair.shapeA)];
  if (pair.manifold.count != 1 || !isCentredBall(state.shapes[at(pair.shapeB)])) return;
  const Ground& ground = *shape.data->ground;
  const BodySlot& ball = state.bodies[at(pair.bodyB)];
  const Vector3& v = ball.velocity.linear;
  const Vector3& normal = pair.manifold.normal;
  if (ground.isFace(shape.item)) {
    const GroundFace& face = ground.faces[at(shape.item)];
    for (std::size_t k = 0; k < 3; ++k) {
      if (!endsAt(face, k)) continue;
      const Outwards out = outwardsOf(ground, face, k, pose);
      const Real place = out.direction.dot(pair.manifold.points[0].position) - out.offset;
      // It has come there by an event, whose time is known to rounding.
      constexpr Real kRounding = 1e-13;
      const Real scale = 1 + std::abs(out.offset);
      if (place >= -kRounding * scale && out.direction.dot(v) > 0) pair.manifold.count = 0;
    }
    return;
  }
  // Round an edge: does anything press the ball on?
  const Real approach = -normal.dot(v);
  if (approach > slowSpeed(state)) return;
  const GroundEdge& edge = ground.edge(shape.item);
  const Vector3 along =
      pose.R_WB * (ground.vertices[at(edge.to)] - ground.vertices[at(edge.from)]).normalized();
  Vector3 round = v + approach * normal;
  constexpr Real kSquare = 1e-6;  // else it goes round a corner, whichever way
  if (std::abs(normal.dot(along)) < kSquare) round -= round.dot(along) * along;
  const Real radius = state.shapes[at(pair.shapeB)].data->reach;
  const Real pressed = -normal.dot(freeAcceleration(state, ball));
  if (round.squaredNorm() >= radius * pressed) pair.manifold.count = 0;
}

Real timeToEdge(const WorldState& state, const PairSlot& pair, const Pose& pose) {
  const ShapeSlot& shape = state.shapes[at(pair.shapeA)];
  if (!isCentredBall(state.shapes[at(pair.shapeB)])) return kNever;
  const Ground& ground = *shape.data->ground;
  const GroundFace& face = ground.faces[at(shape.item)];
  const BodySlot& ball = state.bodies[at(pair.bodyB)];
  Real first = kNever;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!endsAt(face, k)) continue;
    const Outwards out = outwardsOf(ground, face, k, pose);
    const Real place = out.direction.dot(pair.manifold.points[0].position) - out.offset;
    if (place > 0) continue;
    first = std::min(first, risingTime(place, out.direction.dot(ball.velocity.linear),
                                       out.direction.dot(ball.acceleration)));
  }
  return first;
}

namespace {

enum class Touch { none, holds, strikes };

struct Touched {
  Touch touch = Touch::none;
  Real depth = -kNever;  // of what strikes [m]
};

// How a body is held by a piece of ground at a time of this step.
Touched touchAt(WorldState& state, const PairSlot& pair, const Pose& pose, Real time) {
  const ShapeSlot &a = state.shapes[at(pair.shapeA)], &b = state.shapes[at(pair.shapeB)];
  const BodyState then = bodyAt(state, pair.bodyB, time);
  const Real gap = touchGap(state, pair);
  const Manifold manifold = collideGround(*a.data->ground, a.item, pose, b.data->convex,
                                          poseOfShape(state.bodies[at(pair.bodyB)], then, b), gap);
  Touched found;
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint& point = manifold.points[at(i)];
    if (point.separation > gap) continue;
    const Vector3 speed = then.velocity.linear +
                          cross(then.velocity.angular, Vector3(point.position - then.position));
    const bool strikes = manifold.normal.dot(speed) < -slowSpeed(state);
    if (strikes) found.depth = std::max(found.depth, -point.separation);
    if (found.touch != Touch::strikes) found.touch = strikes ? Touch::strikes : Touch::holds;
  }
  return found;
}

// How deep a strike must be to be one. A body that lies in the ground may seem to strike at once,
// with what is none of the few points that are acted on: that counts when it is deeper than these.
Real newDepth(WorldState& state, const PairSlot& pair, const Pose& pose, Real time) {
  const Touched now = touchAt(state, pair, pose, time);
  if (now.touch != Touch::strikes) return -kNever;
  Real deepest = now.depth;
  for (int i = 0; i < pair.manifold.count; ++i) {
    deepest = std::max(deepest, -pair.manifold.points[at(i)].separation);
  }
  return deepest + 2 * touchGap(state, pair);
}

// The time of a strike that has been seen at `high` and not yet at `low`: not so late that the body
// lies in the ground by then, or deeper than it must for this to be one.
Real strikeBetween(WorldState& state, const PairSlot& pair, const Pose& pose, Real low, Real high,
                   Real level) {
  constexpr int kHalvings = 40;
  const Real enough = std::max(Real(0), level) + 2 * touchGap(state, pair);
  Real depth = touchAt(state, pair, pose, high).depth;
  for (int i = 0; i < kHalvings && depth > enough; ++i) {
    const Real middle = (low + high) / 2;
    const Touched found = touchAt(state, pair, pose, middle);
    const bool strikes = found.depth > level;
    (strikes ? high : low) = middle;
    if (strikes) depth = found.depth;
  }
  return high;
}

// The way that any point of a body can go in a time.
Real wayIn(const BodySlot& body, const BodyState& now, const ShapeSlot& shape, Real duration) {
  const Real straight =
      now.velocity.linear.norm() * duration + body.acceleration.norm() * duration * duration / 2;
  if (isCentredBall(shape)) return straight;
  const Real rate = now.velocity.angular.norm() + duration * body.turning.norm();
  return straight + body.reach * rate * duration;
}

// How long it takes a body to turn by a quarter of a radian; of a long time at least some part.
Real partOfTurn(const BodyState& now, Real duration) {
  constexpr Real kTurn = 0.25;
  constexpr int kMostParts = 64;
  const Real rate = now.velocity.angular.norm();
  if (rate * duration <= kTurn) return duration;
  return std::max(kTurn / rate, duration / kMostParts);
}

// A body that touches and turns fast may come down with what is not in the manifold.
Real searchTurned(WorldState& state, const PairSlot& pair, const Pose& pose, Real time, Real end) {
  const Real part = partOfTurn(bodyAt(state, pair.bodyB, time), end - time);
  const bool held = isHeld(state, pair);
  for (Real later = time + part; later < end; later += part) {
    const Touched found = touchAt(state, pair, pose, later);
    if (found.touch != Touch::strikes) continue;
    if (held) return later;
    const Real level = newDepth(state, pair, pose, time);
    if (found.depth > level) return strikeBetween(state, pair, pose, later - part, later, level);
  }
  return kNever;
}

// Looks for the first time at which the body strikes. A sheet may be touched from the side or from
// behind before: that is passed over, a sixteenth of the time at once.
Real searchStrike(WorldState& state, const PairSlot& pair, const Pose& pose, Real time, Real end) {
  constexpr int kMost = 16;
  const ShapeSlot &a = state.shapes[at(pair.shapeA)], &b = state.shapes[at(pair.shapeB)];
  const Ground& ground = *a.data->ground;
  Sweep resting;
  resting.start = pose;
  Shape line = Capsule();
  if (ground.isFace(a.item)) {
    flatHull(ground, a.item, std::get<ConvexHull>(state.work.thin));
  } else {
    std::array<Vector3, 3> ends;
    cornersOfItem(ground, a.item, ends);
    const Vector3 way = ends[1] - ends[0];
    line = Capsule{0, way.norm() / 2};
    resting.start = edgePose(ground, a.item, pose);
  }
  const Shape& piece = ground.isFace(a.item) ? state.work.thin : line;
  const BodySlot& body = state.bodies[at(pair.bodyB)];
  // A body that glides along the sheet is near it all the time: that is not followed closely.
  const Real near = isCentredBall(b) ? 0 : state.settings.touchTolerance / 4;
  const ContactSearch search{.tolerance = near, .maxSteps = 24};
  Real from = time;
  constexpr int kMostRounds = 128;
  for (int passed = 0, round = 0; passed < kMost && round < kMostRounds && from < end; ++round) {
    ++state.counters.firstContacts;
    const BodyState now = bodyAt(state, pair.bodyB, from);
    const Real steady =
        std::min(end - from, body.turnsEvenly ? end - from : partOfTurn(now, end - time));
    const Sweep moving = sweepOf(body, now, b);
    const TimeOfImpact hit = firstContact(piece, resting, b.data->whole, moving, steady, search);
    if (hit.status == ImpactStatus::kNoHit) {
      from = from + steady < end ? from + steady : end;
      continue;
    }
    const Touched found = touchAt(state, pair, pose, from + hit.time);
    if (found.touch == Touch::holds) return kNever;
    if (found.touch == Touch::strikes) {
      const Real level = newDepth(state, pair, pose, time);
      const Real high = from + hit.time;
      if (found.depth > level) return strikeBetween(state, pair, pose, from, high, level);
    }
    // A body that tumbles is not quite where the search has taken it: look again from there.
    const bool again = hit.status == ImpactStatus::kHit && hit.time > 0;
    from += again ? hit.time : hit.time + (end - time) / kMost;
    passed += again ? 0 : 1;
  }
  return kNever;
}

}  // namespace

Real nextGroundContact(WorldState& state, Index index, Real time, Real end, Real followed) {
  const PairSlot& pair = state.pairs[at(index)];
  const ShapeSlot &a = state.shapes[at(pair.shapeA)], &b = state.shapes[at(pair.shapeB)];
  const BodySlot& body = state.bodies[at(pair.bodyB)];
  const Ground& ground = *a.data->ground;
  const Pose pose = poseOfShape(state.bodies[at(pair.bodyA)], a);
  const BodyState now = bodyAt(state, pair.bodyB, time);
  const Real gap = touchGap(state, pair), way = wayIn(body, now, b, end - time);
  const bool isMade = pair.madeAt == time && pair.manifold.count > 0;
  bool closed = false;
  for (int i = 0; isMade && i < pair.manifold.count; ++i) {
    closed = closed || isClosed(state, pair, i);
  }
  const auto soon = [&](Real later) { return later < end - time ? time + later : kNever; };
  if (ground.isFace(a.item)) {
    const Real height = heightOverFace(ground, a.item, pose, b.data->convex,
                                       poseOfShape(state.bodies[at(pair.bodyB)], now, b));
    // Too far in front, or so far behind that it cannot come in front of the plane before.
    if (height > way || height < -way - gap) return kNever;
    // On its plane, here or beside it: what of the body is over the face is followed.
    const bool level = std::abs(height) <= gap + state.settings.restTolerance;
    if (closed || (level && isMade)) {
      const Real next = soon(std::min(followed, closed ? timeToEdge(state, pair, pose) : kNever));
      if (isCentredBall(b)) return next;
      return std::min(next, searchTurned(state, pair, pose, time, end));
    }
    if (level && !isCentredBall(b)) return kNever;
  } else if (closed) {
    if (isCentredBall(b)) return soon(followed);
    return std::min(soon(followed), searchTurned(state, pair, pose, time, end));
  }
  if (way <= gap) return kNever;
  return searchStrike(state, pair, pose, time, end);
}

}  // namespace carom::world
