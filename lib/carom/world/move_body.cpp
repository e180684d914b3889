#include "carom/world/move_body.hpp"

#include <cmath>

#include "carom/motion/careful_sum.hpp"
#include "carom/motion/split_rotor.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"

namespace carom::world {

namespace {

// The closed form, from the anchor that the body has or gets now.
RotorAnchor& anchorOf(WorldState& state, BodySlot& body) {
  if (!body.anchor) {
    const RotorState now{body.orientation, body.pose.R_WB.transpose() * body.velocity.angular};
    giveAnchor(state, body, RotorAnchor{FreeRotor(body.moments, now)});
  }
  return state.anchors[*body.anchor];
}

// Orientation and angular velocity of a body that turns by itself.
void turnFreely(WorldState& state, BodySlot& body, Real duration, BodyState& after) {
  if (!nutates(state, body)) {
    const Vector3 kick = duration * (body.mass.inverseInertia * body.torque);
    const Vector3 mean = body.velocity.angular + kick / 2;
    after.velocity.angular = body.velocity.angular + kick;
    if (mean != Vector3::Zero()) {
      after.orientation = integrateOrientation(body.orientation, mean, duration);
    }
    return;
  }
  RotorState turned;
  if (state.settings.exactRotation && body.torque == Vector3::Zero()) {
    ++state.counters.exactRotations;
    RotorAnchor& anchor = anchorOf(state, body);
    turned = anchor.rotor.at(anchor.since + (anchor.lost + duration));
  } else {
    ++state.counters.splitRotations;
    // A torque kicks before and after; in between the body turns freely.
    const Vector3 half = duration / 2 * (body.mass.inverseInertia * body.torque);
    const RotorState start{body.orientation,
                           body.pose.R_WB.transpose() * (body.velocity.angular + half)};
    turned = SplitRotor(body.moments).step4(start, duration);
  }
  const Matrix3 R = quaternionToMatrix(turned.q_WB);
  after.orientation = turned.q_WB;
  after.velocity.angular = R * turned.angularVelocity;
  if (body.torque != Vector3::Zero()) {
    after.velocity.angular += duration / 2 * (inverseInertiaOf(body, R) * body.torque);
  }
}

}  // namespace

bool needsEnergyKept(const BodySlot& body, const Vector3& rate, Real duration) {
  if (body.turnsEvenly || !isDynamic(body) || rate == Vector3::Zero()) return false;
  constexpr Real kNeedle = 100;
  return rate.norm() * duration > kFastTurn ||
         body.moments.maxCoeff() > kNeedle * body.moments.minCoeff();
}

Matrix3 inverseInertiaOf(const BodySlot& body, const Matrix3& R_WB) {
  if (!isDynamic(body)) return Matrix3::Zero();
  const Matrix3 scaled = R_WB * body.moments.cwiseInverse().asDiagonal();
  const Matrix3 inverse = scaled * R_WB.transpose();
  return (inverse + inverse.transpose()) / 2;
}

Matrix3 middleOf(const BodySlot& body, Real duration) {
  return quaternionToMatrix(
      integrateOrientation(body.orientation, body.velocity.angular, duration / 2));
}

bool nutates(const WorldState& state, const BodySlot& body) {
  return !body.turnsEvenly && state.settings.gyroscopic && isDynamic(body) &&
         body.velocity.angular != Vector3::Zero();
}

Real turningEnergy(const BodySlot& body, const Matrix3& R_WB, const Vector3& rate) {
  const Vector3 w = R_WB.transpose() * rate;
  return w.dot(body.moments.cwiseProduct(w));
}

void keepTurningEnergy(BodySlot& body, const Matrix3& R_WB) {
  Vector3& w = body.velocity.angular;
  const Real before = turningEnergy(body, R_WB, w);
  const Real now = turningEnergy(body, body.pose.R_WB, w);
  if (now > before) w *= std::sqrt(before / now);
}

void refreshPose(BodySlot& body) {
  body.pose = {quaternionToMatrix(body.orientation), body.position};
  if (!body.turnsEvenly) body.mass.inverseInertia = inverseInertiaOf(body, body.pose.R_WB);
}

Vector3 freeAcceleration(const WorldState& state, const BodySlot& body) {
  if (!isDynamic(body)) return Vector3::Zero();
  return state.settings.gravity + body.mass.inverseMass * body.force;
}

BodyState bodyAt(WorldState& state, Index index, Real time) {
  BodySlot& body = state.bodies[at(index)];
  BodyState after{body.position, body.orientation, body.velocity, body.lost};
  const Real duration = time - body.clock;
  if (duration == 0 || body.asleep || body.kind == BodyKind::immovable) return after;
  const Vector3& a = body.acceleration;
  after.velocity.linear = body.velocity.linear + duration * a;
  const bool byMean = state.settings.trapezoidal && !body.byEnd;
  const Vector3 mean = byMean || body.isFree ? Vector3(body.velocity.linear + duration / 2 * a)
                                             : after.velocity.linear;
  const Vector3 way = duration * mean;
  if (body.isFree) {
    // Equal ways of equal steps are rounded alike, so that errors would add up.
    addCarefully(after.position, after.lost, way);
    turnFreely(state, body, duration, after);
    return after;
  }
  after.position = body.position + way;
  after.velocity.angular = body.velocity.angular + duration * body.turning;
  const Vector3 turn = byMean ? Vector3(body.velocity.angular + duration / 2 * body.turning)
                              : after.velocity.angular;
  if (turn != Vector3::Zero()) {
    after.orientation = integrateOrientation(body.orientation, turn, duration);
  }
  return after;
}

void moveBody(WorldState& state, Index index, Real time, bool last) {
  BodySlot& body = state.bodies[at(index)];
  if (time == body.clock) return;
  const BodyState after = bodyAt(state, index, time);
  const Quaternion &q = after.orientation, &before = body.orientation;
  // Contacts have pushed the body as it would lie in the middle of this time.
  const Real duration = time - body.clock;
  const bool isFast = !body.isFree && needsEnergyKept(body, body.velocity.angular, duration);
  const Matrix3 middle = isFast ? middleOf(body, duration) : Matrix3::Identity();
  const bool turned = q.w != before.w || q.x != before.x || q.y != before.y || q.z != before.z;
  if (body.anchor && !body.isFree) dropAnchor(state, body);
  if (body.anchor) {
    RotorAnchor& anchor = state.anchors[*body.anchor];
    addCarefully(anchor.since, anchor.lost, time - body.clock);
  }
  body.position = after.position;
  body.lost = after.lost;
  body.orientation = after.orientation;
  body.velocity = last && !body.isFree ? body.atEnd : after.velocity;
  body.clock = time;
  if (turned) {
    refreshPose(body);
  } else {
    body.pose.p_WB = body.position;
  }
  if (isFast) keepTurningEnergy(body, middle);
}

void giveAnchor(WorldState& state, BodySlot& body, const RotorAnchor& anchor) {
  if (state.freeAnchors.empty()) {
    body.anchor = state.anchors.size();
    state.anchors.push_back(anchor);
    state.freeAnchors.reserve(state.anchors.capacity());  // dropping one takes no memory
  } else {
    body.anchor = state.freeAnchors.back();
    state.freeAnchors.pop_back();
    state.anchors[*body.anchor] = anchor;
  }
}

void dropAnchor(WorldState& state, BodySlot& body) {
  if (!body.anchor) return;
  state.freeAnchors.push_back(*body.anchor);
  body.anchor.reset();
}

Vector3 turnedRate(const BodySlot& body, Real duration) {
  const Vector3& w = body.velocity.angular;
  const Matrix3& R = body.pose.R_WB;
  const Vector3 L = R * body.moments.cwiseProduct(R.transpose() * w);
  // The angular momentum stays; the axes turn with the mean rate, which two rounds find well
  // enough.
  Vector3 after = w;
  for (int round = 0; round < 2; ++round) {
    const Quaternion turn = integrateOrientation(Quaternion{}, (w + after) / 2, duration);
    const Matrix3 turned = quaternionToMatrix(turn) * R;
    after = turned * (turned.transpose() * L).cwiseQuotient(body.moments);
  }
  // Two rounds are not enough for a body that turns far in this time; then its energy at least
  // stays what it was, as it lies in the middle, where contacts push it.
  if (needsEnergyKept(body, w, duration)) {
    const Real before = turningEnergy(body, R, w);
    const Real now = turningEnergy(body, middleOf(body, duration), after);
    if (now > before) after *= std::sqrt(before / now);
  }
  return after;
}

}  // namespace carom::world
