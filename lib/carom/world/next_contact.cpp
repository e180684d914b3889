#include "carom/world/next_contact.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/detection/signed_distance.hpp"
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
  sweep.start = poseOfShape(now, shape);
  sweep.velocity = now.velocity.linear;
  sweep.angularVelocity = now.velocity.angular;
  if (!body.asleep) sweep.acceleration = body.acceleration;
  if (!shape.centred) sweep.centre = -(shape.pose.R_WB.transpose() * shape.pose.p_WB);
  return sweep;
}

namespace {

TimeOfImpact searchFirst(const ShapeSlot& a, const Sweep& A, const ShapeSlot& b, const Sweep& B,
                         Real duration) {
  if (a.data->isBall && b.data->isBall && A.acceleration == B.acceleration && a.centred &&
      b.centred) {
    // Seen from each other both move straight, whatever pulls at both.
    return sweptBalls({a.data->reach, A.start.p_WB, A.velocity},
                      {b.data->reach, B.start.p_WB, B.velocity}, duration);
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

// A body that touches and turns far may come down with what is not in the manifold: it is looked at
// a few times until `end`. Returns when, or `end` if that is the next event, or never if it is the
// end of the step.
Real nextOfTurned(WorldState& state, const PairSlot& pair, Real time, Real end, Real endOfStep) {
  constexpr int kMostParts = 64;
  const Real otherwise = end < endOfStep ? end : kNever;
  const ShapeSlot &a = state.shapes[at(pair.shapeA)], &b = state.shapes[at(pair.shapeB)];
  const auto rateOf = [&](const BodySlot& body, const ShapeSlot& shape) {
    if (isCentredBall(shape)) return Real(0);
    return body.velocity.angular.norm() + (end - time) * body.turning.norm();
  };
  const Real turn = (end - time) * std::max(rateOf(state.bodies[at(pair.bodyA)], a),
                                            rateOf(state.bodies[at(pair.bodyB)], b));
  if (!(turn > kFastTurn)) return otherwise;
  const int parts = static_cast<int>(std::min(Real(kMostParts), std::ceil(turn / kFastTurn)));
  for (int part = 1; part < parts; ++part) {
    const Real later = time + (end - time) * part / parts;
    const BodyState A = bodyAt(state, pair.bodyA, later), B = bodyAt(state, pair.bodyB, later);
    const Separation found =
        signedDistance(a.data->whole, poseOfShape(A, a), b.data->whole, poseOfShape(B, b));
    if (found.separation >= -state.settings.restTolerance) continue;
    const Vector3 point = (found.pointA + found.pointB) / 2;
    const Vector3 speed =
        B.velocity.linear + cross(B.velocity.angular, Vector3(point - B.position)) -
        A.velocity.linear - cross(A.velocity.angular, Vector3(point - A.position));
    if (found.normal.dot(speed) < -slowSpeed(state)) return later;
  }
  return otherwise;
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
    return nextOfTurned(state, pair, time, after < duration ? time + after : end, end);
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
  const TimeOfImpact hit =
      searchFirst(a, sweepOf(bodyA, nowA, a), b, sweepOf(bodyB, nowB, b), duration);
  if (hit.status == ImpactStatus::kNoHit) return kNever;
  if (pair.madeAt == time && time + hit.time == time) {
    // The search finds a touch where the manifold has a little gap, which counts: it is what is
    // acted on. A touch that nobody acts on is found again and again.
    return nextOfTouch();
  }
  return time + hit.time;
}

}  // namespace carom::world
