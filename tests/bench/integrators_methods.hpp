#pragma once
// Methods that stand beside those of the library: the source's listings, and ways to turn a body
// that others have found.

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/motion/explicit_gyroscopic_step.hpp"
#include "carom/motion/fixed_steps.hpp"
#include "carom/motion/gyroscopic_step.hpp"
#include "carom/motion/rotor.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"
#include "carom/rotation/rotate_point.hpp"

namespace carom::bench {

/// The listing of section 7.2: Taylor for the position, explicit Euler for the velocity.
template <class V, class Force>
void sourceVerletStep(FixedState<V>& s, Real t, Real dt, Force&& acceleration) {
  const V a = acceleration(t, s.position, s.velocity);
  s.position = s.position + dt * s.velocity + dt * dt / 2 * a;
  s.velocity = s.velocity + dt * a;
}

/// The listing of section 7.3 with x read as s: the force is asked for twice at the old place.
template <class V, class Force>
void sourceVelocityVerletStep(FixedState<V>& s, Real t, Real dt, Force&& acceleration) {
  const V before = acceleration(t, s.position, s.velocity);
  const V position = s.position + dt * s.velocity + dt * dt / 2 * before;
  const V after = acceleration(t, s.position, s.velocity);
  s.position = position;
  s.velocity = s.velocity + dt / 2 * (before + after);
}

/// An engine's step of a free body: the gyroscopic term, then the attitude along the new angular
/// velocity.
inline RotorState engineStep(const Vector3& moments, const RotorState& s, Real dt,
                             bool implicitTerm) {
  const Matrix3 inertia = moments.asDiagonal();
  const Vector3 w = implicitTerm ? gyroscopicStep(inertia, s.angularVelocity, dt)
                                 : explicitGyroscopicStep(moments, s.angularVelocity, dt);
  return {renormalize(hamiltonProduct(s.q_WB, quaternionExponential(dt * w))), w};
}

/// The second-order method of Buss (2000) in its augmented form: the attitude by one turn along a
/// Taylor series of the angular velocity, and L kept in the world.
inline RotorState bussStep(const Vector3& moments, const RotorState& s, Real dt) {
  const Vector3 w = s.angularVelocity;
  const Vector3 a = eulerAcceleration(moments, w, Vector3::Zero());
  const Vector3 turn = dt * w + dt * dt / 2 * a + dt * dt * dt / 12 * cross(a, w);
  const Quaternion step = quaternionExponential(turn);
  const Vector3 L = moments.cwiseProduct(w);
  return {renormalize(hamiltonProduct(s.q_WB, step)),
          rotatePoint(conjugate(step), L).cwiseQuotient(moments)};
}

/// The implicit midpoint rule for L in the body, and the attitude by a turn along the angular
/// velocity in the middle. Keeps |L| and the energy.
inline RotorState midpointStep(const Vector3& moments, const RotorState& s, Real dt) {
  const Vector3 L = moments.cwiseProduct(s.angularVelocity);
  Vector3 next = L, w = s.angularVelocity;
  constexpr int kMost = 100;
  for (int i = 0; i < kMost; ++i) {
    const Vector3 middle = (L + next) / 2;
    w = middle.cwiseQuotient(moments);
    const Vector3 better = L + dt * cross(middle, w);
    const Real change = (better - next).cwiseAbs().maxCoeff();
    next = better;
    if (!(change > 1e-16 * L.cwiseAbs().maxCoeff())) break;
  }
  return {renormalize(hamiltonProduct(s.q_WB, quaternionExponential(dt * w))),
          next.cwiseQuotient(moments)};
}

}  // namespace carom::bench
