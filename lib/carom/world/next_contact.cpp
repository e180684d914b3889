#include "carom/world/next_contact.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/detection/rounded_distance.hpp"
#include "carom/manifold/contact_ids.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/toi/swept_ball_plane.hpp"
#include "carom/toi/swept_balls.hpp"
#include "carom/world/contact_phase.hpp"
#include "carom/world/leave_ground.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

// The first time at which gap + speed t + pull t^2 / 2 comes down to zero. A gap that is closed
// already has to open first.
Real closingTime(Real gap, Real speed, Real pull, bool closed) {
  if (closed) return speed > 0 && pull < 0 ? -2 * speed / pull : kNever;
  const Real root = speed * speed - 2 * pull * gap;
  if (root < 0) return kNever;
  if (speed < 0) return 2 * gap / (-speed + std::sqrt(root));
  return pull < 0 ? (speed + std::sqrt(root)) / -pull : kNever;
}

// How the velocity of a body's point changes: by its acceleration, its turning, and by going round.
Vector3 pointAcceleration(const BodySlot& body, const Vector3& arm, bool material) {
  if (!material) return body.acceleration;
  const Vector3& w = body.velocity.angular;
  return body.acceleration + cross(body.turning, arm) + cross(w, cross(w, arm));
}

// Follows the points of a pair that touches and that no phase holds.
Real nextOfPoints(const WorldState& state, const PairSlot& pair) {
  const BodySlot &a = state.bodies[at(pair.bodyA)], &b = state.bodies[at(pair.bodyB)];
  const Vector3& n = pair.manifold.normal;
  const Real slow = slowSpeed(state);
  Real first = kNever;
  for (int i = 0; i < pair.manifold.count; ++i) {
    const ManifoldPoint& point = pair.manifold.points[at(i)];
    const bool closed = isClosed(state, pair, i);
    const Real speed = partingSpeed(state, pair, i);
    if (closed && speed <= slow) continue;  // held
    const PatchPoint arms = armsOf(state, pair, i);
    const auto isRound = [](std::uint32_t half) { return ((half >> 14) & 3u) == 0; };
    const Vector3 pull = pointAcceleration(b, arms.armB, !isRound(point.id)) -
                         pointAcceleration(a, arms.armA, !isRound(point.id >> 16));
    first = std::min(first, closingTime(point.separation, speed, n.dot(pull), closed));
  }
  return first;
}

}  // namespace

Sweep sweepOf(const BodySlot& body, const BodyState& now, const ShapeSlot& shape) {
  Sweep sweep;
  sweep.start = poseOfShape(body, now, shape);
  sweep.velocity = now.velocity.linear;
  sweep.angularVelocity = now.velocity.angular;
  if (!body.asleep) sweep.acceleration = body.acceleration;
  if (!shape.centred) sweep.centre = -(shape.pose.R_WB.transpose() * shape.pose.p_WB);
  return sweep;
}

namespace {

// What rounding took from where B is, as seen from A, is known of balls alone [m].
TimeOfImpact searchFirst(const ShapeSlot& a, const Sweep& A, const ShapeSlot& b, const Sweep& B,
                         const Vector3& lost, Real duration) {
  if (a.data->isBall && b.data->isBall && A.acceleration == B.acceleration && a.centred &&
      b.centred) {
    // Seen from each other both move straight, whatever pulls at both.
    const Vector3 apart = B.start.p_WB - A.start.p_WB + lost;
    return sweptBalls({a.data->reach, Vector3::Zero(), A.velocity},
                      {b.data->reach, apart, B.velocity}, duration);
  }
  const bool resting = A.velocity == Vector3::Zero() && A.angularVelocity == Vector3::Zero();
  if (a.data->isHalfSpace && b.data->isBall && b.centred && a.centred && resting) {
    const HalfSpace& plane = std::get<HalfSpace>(a.data->whole);
    const Vector3 normal = A.start.R_WB * plane.normal;
    const HalfSpace placed{normal, plane.offset + normal.dot(A.start.p_WB)};
    return sweptBallPlane({b.data->reach, B.start.p_WB, B.velocity}, B.acceleration, placed,
                          duration);
  }
  return firstContact(a.data->whole, A, b.data->whole, B, duration);
}

// How far the bodies of a pair turn in a time at most; what is a ball does not count [rad].
Real turnOf(const WorldState& state, const PairSlot& pair, Real duration) {
  const auto rateOf = [&](Index index, Index shape) {
    const BodySlot& body = state.bodies[at(index)];
    if (isCentredBall(state.shapes[at(shape)])) return Real(0);
    return body.velocity.angular.norm() + duration * body.turning.norm();
  };
  return duration * std::max(rateOf(pair.bodyA, pair.shapeA), rateOf(pair.bodyB, pair.shapeB));
}

// How a pair lies at a time, wherever its bodies have turned.
struct Nearness {
  Real separation = 0;  // [m]
  bool approach = false;
};

Nearness nearnessAt(WorldState& state, const PairSlot& pair, Real time) {
  const ShapeSlot &a = state.shapes[at(pair.shapeA)], &b = state.shapes[at(pair.shapeB)];
  const BodyState A = bodyAt(state, pair.bodyA, time), B = bodyAt(state, pair.bodyB, time);
  const Separation found =
      roundedDistance(a.data->whole, poseOfShape(state.bodies[at(pair.bodyA)], A, a), b.data->whole,
                      poseOfShape(state.bodies[at(pair.bodyB)], B, b));
  const Vector3 point = (found.pointA + found.pointB) / 2;
  const Vector3 speed = B.velocity.linear + cross(B.velocity.angular, Vector3(point - B.position)) -
                        A.velocity.linear - cross(A.velocity.angular, Vector3(point - A.position));
  return {found.separation, found.normal.dot(speed) < -slowSpeed(state)};
}

int partsOf(Real turn) {
  constexpr int kMostParts = 64;
  return static_cast<int>(std::clamp(std::ceil(turn / kFastTurn), Real(1), Real(kMostParts)));
}

// A body that touches and turns far may come down with what is not in the manifold: it is looked at
// a few times until `end`. Returns when, or `end` if that is the next event, or never if it is the
// end of the step.
Real nextOfTurned(WorldState& state, const PairSlot& pair, Real time, Real end, Real endOfStep) {
  const Real otherwise = end < endOfStep ? end : kNever;
  const Real turn = turnOf(state, pair, end - time);
  if (!(turn > kFastTurn)) return otherwise;
  const int parts = partsOf(turn);
  for (int part = 1; part < parts; ++part) {
    const Real later = time + (end - time) * part / parts;
    const Nearness found = nearnessAt(state, pair, later);
    if (found.separation < -state.settings.restTolerance && found.approach) return later;
  }
  return otherwise;
}

// When a pair that nothing holds comes to overlap until `end`, wherever its bodies turn, deeper than
// it does already; never, if it does not. A cylinder that has bounced on its rim comes down with the
// other rim; and a search takes spins to be even, which those of bodies that tumble are not. Found
// too late, they would lie in each other and be lifted out with energy from nothing.
Real firstOverlap(WorldState& state, const PairSlot& pair, Real time, Real end) {
  const Real tolerance = state.settings.touchTolerance;
  Real level = -tolerance;
  const auto isIn = [&](const Nearness& found) {
    return found.separation < level && found.approach;
  };
  const int parts = partsOf(turnOf(state, pair, end - time));
  Real low = time;
  for (int part = 1; part <= parts; ++part) {
    Real high = part == parts ? end : time + (end - time) * part / parts;
    Nearness there = nearnessAt(state, pair, high);
    if (isIn(there) && low == time) {
      // What lies in the other at the start and parts may seem to approach elsewhere on its face.
      const Nearness start = nearnessAt(state, pair, time);
      if (isIn(start)) level = start.separation - tolerance;
    }
    if (!isIn(there)) {
      low = high;
      continue;
    }
    // As deep as that it is beyond what rounding makes, and an impact that is there to be acted on.
    constexpr int kHalvings = 40;
    for (int i = 0; i < kHalvings && there.separation < level - tolerance; ++i) {
      const Real middle = (low + high) / 2;
      const Nearness found = nearnessAt(state, pair, middle);
      (isIn(found) ? high : low) = middle;
      if (high == middle) there = found;
    }
    return high;
  }
  return kNever;
}

bool tumbles(const WorldState& state, const PairSlot& pair) {
  return nutates(state, state.bodies[at(pair.bodyA)]) ||
         nutates(state, state.bodies[at(pair.bodyB)]);
}

}  // namespace

Real nextContact(WorldState& state, Index index, Real time, Real end) {
  PairSlot& pair = state.pairs[at(index)];
  const Real duration = end - time;
  if (!state.settings.continuous || !(duration > 0)) return kNever;
  if (state.shapes[at(pair.shapeA)].data->ground) {
    const Real followed = pair.madeAt == time ? nextOfPoints(state, pair) : kNever;
    return nextGroundContact(state, index, time, end, followed);
  }
  const auto nextOfTouch = [&] {
    const Real after = nextOfPoints(state, pair);
    const Real next = after < duration ? time + after : end;
    if (isHeld(state, pair)) return nextOfTurned(state, pair, time, next, end);
    return std::min(firstOverlap(state, pair, time, next), after < duration ? next : kNever);
  };
  if (pair.madeAt == time) {
    bool closed = false;
    for (int i = 0; i < pair.manifold.count; ++i) closed = closed || isClosed(state, pair, i);
    if (closed) return nextOfTouch();
  }
  const ShapeSlot &a = state.shapes[at(pair.shapeA)], &b = state.shapes[at(pair.shapeB)];
  const BodySlot &bodyA = state.bodies[at(pair.bodyA)], &bodyB = state.bodies[at(pair.bodyB)];
  const BodyState nowA = bodyAt(state, pair.bodyA, time), nowB = bodyAt(state, pair.bodyB, time);

  // Too slow to come together?
  if (pair.madeAt == time) {
    Real gap = kNever;
    for (int i = 0; i < pair.manifold.count; ++i) {
      gap = std::min(gap, pair.manifold.points[at(i)].separation);
    }
    const auto turning = [&](const BodySlot& body, const BodyState& now, const ShapeSlot& shape) {
      if (isCentredBall(shape)) return Real(0);
      const Real rate = now.velocity.angular.norm() + duration * body.turning.norm();
      return body.reach * rate * duration;
    };
    const Vector3 speed = nowB.velocity.linear - nowA.velocity.linear;
    const Vector3 pull = bodyB.acceleration - bodyA.acceleration;
    const Real way = speed.norm() * duration + pull.norm() * duration * duration / 2 +
                     turning(bodyA, nowA, a) + turning(bodyB, nowB, b);
    if (pair.manifold.count > 0 ? way < gap : way < state.settings.contactMargin) return kNever;
  }
  ++state.counters.firstContacts;
  const TimeOfImpact hit = searchFirst(a, sweepOf(bodyA, nowA, a), b, sweepOf(bodyB, nowB, b),
                                       nowB.lost - nowA.lost, duration);
  const Real next = hit.status == ImpactStatus::kNoHit ? kNever : time + hit.time;
  if (pair.madeAt == time && next == time) {
    // The search finds a touch where the manifold has a little gap, which counts: it is what is
    // acted on. A touch that nobody acts on is found again and again.
    return nextOfTouch();
  }
  if (!tumbles(state, pair)) return next;
  return std::min(next, firstOverlap(state, pair, time, std::min(next, end)));
}

}  // namespace carom::world
