#include "carom/motion/split_rotor.hpp"

#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/length.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {
namespace {

// Below this half angle the series that follow are good to a tenth of a rounding error: y^10/10! is
// 1.5e-17 for the angle y = 3/32, and the terms that the half angle leaves out are smaller still.
constexpr Real kShort = 3.0 / 64;

// (sin x - x) / x^3 and (cos x - 1) / x^2 by their series; z is x^2. Grouped so that a processor
// works on both halves of each sum at once.
Real sineSeries(Real z) {
  return (-1.0 / 6 + z * (1.0 / 120)) + z * z * (-1.0 / 5040 + z * (1.0 / 362880));
}
Real cosineSeries(Real z) {
  return (-1.0 / 2 + z * (1.0 / 24)) + z * z * (-1.0 / 720 + z * (1.0 / 40320));
}

// A body in the numbers of the loops: the turn w, q that it has made since the start, and its
// momentum L. The axes are named after what is done about them, the round one first, the odd one
// second; a cycle of axes stays right-handed.
struct Turning {
  Real w = 1;
  Real q[3] = {0, 0, 0};
  Real L[3] = {0, 0, 0};
};

// The motion of a body with the energy rate * L_axis^2 / 2, for a time of 2 halfRate / rate. It
// turns about that axis at rate * L_axis, and L, which the world sees at rest, turns the other way
// in the body.
//
// Each turn waits for the one before, so what counts is the longest chain of operations. For short
// turns the sine of the whole angle has a series of its own, instead of being made from that of the
// half, and its terms are added to L smallest last; that brought a step of order 4 from 260 to 210
// ns.
template <int axis>
[[gnu::always_inline]] inline void turnAbout(Real halfRate, Turning& b) {
  constexpr int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const Real half = halfRate * b.L[axis];
  const Real a = b.L[j], c = b.L[k];
  Real sine, cosine;  // of the half angle
  if (std::abs(half) < kShort) {
    const Real angle = 2 * half, z = angle * angle, cubed = angle * z;
    const Real s = sineSeries(z), r = cosineSeries(z);
    b.L[j] = (a + angle * c) + ((cubed * c) * s + (z * a) * r);
    b.L[k] = (c - angle * a) - ((cubed * a) * s - (z * c) * r);
    const Real h = half * half;
    sine = half + half * h * sineSeries(h);
    cosine = 1 + h * cosineSeries(h);
  } else {
    const SineCosine e = sineCosine(half);
    sine = e.sine;
    cosine = e.cosine;
    const Real whole = 2 * sine * cosine, less = 2 * sine * sine;  // sine, and 1 - cosine
    b.L[j] = a - (less * a - whole * c);
    b.L[k] = c - (less * c + whole * a);
  }
  // The quaternion times (cosine, sine along the axis), in which half of the terms are zero.
  const Real w = b.w, x = b.q[axis], y = b.q[j], u = b.q[k];
  b.w = w * cosine - x * sine;
  b.q[axis] = x * cosine + w * sine;
  b.q[j] = y * cosine + u * sine;
  b.q[k] = u * cosine - y * sine;
}

// The turn by twice the length of a vector, about it. A short one needs no length: the series are in
// its square.
Quaternion turnAlong(const Vector3& half) {
  const Real z = half.squaredNorm();
  if (z < kShort * kShort) {
    const Vector3 v = half + z * sineSeries(z) * half;
    return {1 + z * cosineSeries(z), v.x(), v.y(), v.z()};
  }
  const Real size = length(half);
  const SineCosine e = sineCosine(size);
  const Vector3 v = e.sine / size * half;
  return {e.cosine, v.x(), v.y(), v.z()};
}

// Lengths of the turns about the odd and about the round axis [1]. Each list adds up to one.
constexpr Real kOdd2[2] = {0.5, 0.5}, kRound2[1] = {1};

// Blanes and Moan 2002, S6.
constexpr Real kA1 = 0.0792036964311957, kA2 = 0.353172906049774, kA3 = -0.0420650803577195;
constexpr Real kA4 = 1 - 2 * (kA1 + kA2 + kA3);
constexpr Real kB1 = 0.209515106613362, kB2 = -0.143851773179818, kB3 = 0.5 - (kB1 + kB2);
constexpr Real kOdd4[7] = {kA1, kA2, kA3, kA4, kA3, kA2, kA1};
constexpr Real kRound4[6] = {kB1, kB2, kB3, kB3, kB2, kB1};

}  // namespace

SplitRotor::SplitRotor(const Vector3& moments) : moments_(moments) {
  requireMoments(moments);
  // The two moments that are nearest to each other have the smallest difference of rates; the
  // smaller it is, the smaller the error of taking turns.
  Real nearest = std::numeric_limits<Real>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    const Real difference = std::abs(moments[j] - moments[k]) / (moments[j] * moments[k]);
    if (difference >= nearest) continue;
    nearest = difference;
    round_ = axis;
    equal_ = moments[k];
    // As quotients of differences, so that near moments keep their digits.
    oddRate_ = (moments[k] - moments[j]) / (moments[k] * moments[j]);
    roundRate_ = (moments[k] - moments[axis]) / (moments[k] * moments[axis]);
  }
}

TurningBody SplitRotor::begin(const RotorState& state, Real dt) const {
  requireUsable(state);
  requireFinite(dt, "dt");
  return {state.q_WB, moments_.cwiseProduct(state.angularVelocity)};
}

RotorState SplitRotor::end(const TurningBody& body) const {
  return {renormalize(body.q_WB), angularVelocity(body.momentum)};
}

// `count` steps whose parts are `odd` and `round`, beginning and ending with an odd one. Which axis
// is the round one, r, is known to the compiler, so that nothing is looked up in memory on the way.
template <int n, int r>
void SplitRotor::turnAxes(TurningBody& body, Real dt, int count, const Real (&odd)[n + 1],
                          const Real (&round)[n]) const {
  constexpr int o = (r + 1) % 3, e = (r + 2) % 3;
  const Vector3 L = body.momentum;
  Turning b;
  b.L[0] = L[r], b.L[1] = L[o], b.L[2] = L[e];
  const Real oddTurn = oddRate_ * dt / 2, roundTurn = roundRate_ * dt / 2;
  if (oddRate_ == 0) {
    turnAbout<0>(count * roundTurn, b);  // round: one turn does it, without error
  } else {
    if (count > 0) turnAbout<1>(odd[0] * oddTurn, b);
    for (int step = 0; step < count; ++step) {
      for (int i = 0; i < n; ++i) {
        turnAbout<0>(round[i] * roundTurn, b);
        // The last turn of a step and the first of the next are one.
        const bool joins = i + 1 == n && step + 1 < count;
        turnAbout<1>((joins ? odd[n] + odd[0] : odd[i + 1]) * oddTurn, b);
      }
    }
  }
  body.momentum[r] = b.L[0], body.momentum[o] = b.L[1], body.momentum[e] = b.L[2];
  Vector3 v;
  v[r] = b.q[0], v[o] = b.q[1], v[e] = b.q[2];

  // About L, for all steps at once, and before the others, which turn L in the body.
  const Quaternion aboutL = turnAlong(count * dt / (2 * equal_) * L);
  body.q_WB = hamiltonProduct(hamiltonProduct(body.q_WB, aboutL), {b.w, v.x(), v.y(), v.z()});
}

template <int n>
void SplitRotor::turn(TurningBody& body, Real dt, int count, const Real (&odd)[n + 1],
                      const Real (&round)[n]) const {
  if (round_ == 0) return turnAxes<n, 0>(body, dt, count, odd, round);
  if (round_ == 1) return turnAxes<n, 1>(body, dt, count, odd, round);
  turnAxes<n, 2>(body, dt, count, odd, round);
}

void SplitRotor::turn4(TurningBody& body, Real dt) const {
  turn<6>(body, dt, 1, kOdd4, kRound4);
}

RotorState SplitRotor::step2(const RotorState& state, Real dt) const {
  TurningBody body = begin(state, dt);
  turn<1>(body, dt, 1, kOdd2, kRound2);
  return end(body);
}

RotorState SplitRotor::step4(const RotorState& state, Real dt) const {
  return steps4(state, dt, 1);
}

RotorState SplitRotor::steps4(const RotorState& state, Real dt, int count) const {
  if (count < 0) reject("count", std::to_string(count), "must be zero or more");
  TurningBody body = begin(state, dt);
  turn<6>(body, dt, count, kOdd4, kRound4);
  return end(body);
}

}  // namespace carom
