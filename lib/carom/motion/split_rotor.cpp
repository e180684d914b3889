#include "carom/motion/split_rotor.hpp"

#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/length.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

SplitRotor::SplitRotor(const Vector3& moments) : moments_(moments) {
  requireMoments(moments);
  // The two moments that are nearest to each other are taken for equal; the smaller the difference,
  // the smaller the error of taking turns.
  Real nearest = std::numeric_limits<Real>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    const Real difference = std::abs(moments[j] - moments[k]) / (moments[j] * moments[k]);
    if (difference >= nearest) continue;
    nearest = difference;
    round_ = axis;
    odd_ = j;
    equal_ = moments[k];
    // As quotients of differences, so that near moments keep their digits.
    oddRate_ = (moments[k] - moments[j]) / (moments[k] * moments[j]);
    roundRate_ = (moments[k] - moments[axis]) / (moments[k] * moments[axis]);
  }
}

// The motion of a body with the energy rate * L_axis^2 / 2. It turns about that axis at rate *
// L_axis, and L, which the world sees at rest, turns the other way in the body.
void SplitRotor::turnAbout(int axis, Real rate, Real dt, Moving& body) const {
  const SineCosine half = sineCosine(rate * body.momentum[axis] * dt / 2);
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const Real sine = 2 * half.sine * half.cosine;
  const Real less = 2 * half.sine * half.sine;  // 1 - cosine
  const Real a = body.momentum[j], b = body.momentum[k];
  body.momentum[j] = a - less * a + sine * b;
  body.momentum[k] = b - less * b - sine * a;

  Vector3 v = Vector3::Zero();
  v[axis] = half.sine;
  body.q = hamiltonProduct(body.q, {half.cosine, v.x(), v.y(), v.z()});
}

// The motion of a body that is round about an axis: steadily about L, and about that axis.
void SplitRotor::turnRound(Real dt, Moving& body) const {
  const Real size = length(body.momentum);
  if (size == 0) return;
  const SineCosine half = sineCosine(size * dt / (2 * equal_));
  const Vector3 v = half.sine / size * body.momentum;
  body.q = hamiltonProduct(body.q, {half.cosine, v.x(), v.y(), v.z()});
  turnAbout(round_, roundRate_, dt, body);
}

RotorState SplitRotor::step2(const RotorState& state, Real dt) const {
  requireUsable(state);
  requireFinite(dt, "dt");
  Moving body = {state.q_WB, moments_.cwiseProduct(state.angularVelocity)};
  turnAbout(odd_, oddRate_, dt / 2, body);
  turnRound(dt, body);
  turnAbout(odd_, oddRate_, dt / 2, body);
  return {renormalize(body.q), body.momentum.cwiseQuotient(moments_)};
}

RotorState SplitRotor::step4(const RotorState& state, Real dt) const {
  // Blanes and Moan 2002, S6. The sums a1 + ... + a1 and b1 + ... + b1 are one.
  constexpr Real a1 = 0.0792036964311957, a2 = 0.353172906049774, a3 = -0.0420650803577195;
  constexpr Real a4 = 1 - 2 * (a1 + a2 + a3);
  constexpr Real b1 = 0.209515106613362, b2 = -0.143851773179818, b3 = 0.5 - (b1 + b2);
  constexpr Real kOdd[] = {a1, a2, a3, a4, a3, a2};
  constexpr Real kRound[] = {b1, b2, b3, b3, b2, b1};

  if (oddRate_ == 0) return step2(state, dt);  // round: one turn does it, without error
  requireUsable(state);
  requireFinite(dt, "dt");
  Moving body = {state.q_WB, moments_.cwiseProduct(state.angularVelocity)};
  for (int i = 0; i < 6; ++i) {
    turnAbout(odd_, oddRate_, kOdd[i] * dt, body);
    turnRound(kRound[i] * dt, body);
  }
  turnAbout(odd_, oddRate_, a1 * dt, body);
  return {renormalize(body.q), body.momentum.cwiseQuotient(moments_)};
}

}  // namespace carom
