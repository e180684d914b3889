#pragma once
// What do the steps cost when the number of coordinates is known to the compiler?
//
// The steps of this chapter take any number of coordinates and any function, and pay for it: each
// sum of columns asks the system for memory, each look at the forces goes through a pointer. Here
// are the same formulas for numbers and vectors of fixed size, in place, with the function in plain
// sight of the compiler. A step of a pendulum takes nanoseconds instead of some tenths of a
// microsecond. Tests hold them to the plain ones, bit for bit.
// Not handled: bad input, which the plain steps refuse, and which here goes in and comes out.

#include "carom/core/real.hpp"

namespace carom {

/// Position and velocity of a system whose size the compiler knows.
/// \tparam V a number or a vector of fixed size
/// \ingroup motion
template <class V>
struct FixedState {
  V position;  ///< [m]
  V velocity;  ///< [m/s]
};

/// The step of explicitEuler(), in place. \ingroup motion
/// \tparam V a number or a vector of fixed size
/// \tparam Force called as acceleration(time, position, velocity), answers a V
/// \param state is changed to that after the step
/// \param time at the start [s] \param dt length of the step [s]
/// \param acceleration a(t, x, v) [m/s^2]
template <class V, class Force>
void explicitEulerStep(FixedState<V>& state, Real time, Real dt, Force&& acceleration) {
  const V a = acceleration(time, state.position, state.velocity);
  state.position = state.position + dt * state.velocity;
  state.velocity = state.velocity + dt * a;
}

/// The step of semiImplicitEuler(), in place. \ingroup motion
/// \tparam V a number or a vector of fixed size
/// \tparam Force called as acceleration(time, position, velocity), answers a V
/// \param state is changed to that after the step
/// \param time at the start [s] \param dt length of the step [s]
/// \param acceleration a(t, x, v) [m/s^2]
template <class V, class Force>
void semiImplicitEulerStep(FixedState<V>& state, Real time, Real dt, Force&& acceleration) {
  const V a = acceleration(time, state.position, state.velocity);
  state.velocity = state.velocity + dt * a;
  state.position = state.position + dt * state.velocity;
}

/// The step of velocityVerlet(), in place. \ingroup motion
/// \tparam V a number or a vector of fixed size
/// \tparam Force called as acceleration(time, position, velocity), answers a V
/// \param state is changed to that after the step
/// \param time at the start [s] \param dt length of the step [s]
/// \param acceleration a(t, x, v) [m/s^2]
template <class V, class Force>
void velocityVerletStep(FixedState<V>& state, Real time, Real dt, Force&& acceleration) {
  const V before = acceleration(time, state.position, state.velocity);
  const V position = state.position + dt * state.velocity + dt * dt / 2 * before;
  const V guess = state.velocity + dt * before;
  const V after = acceleration(time + dt, position, guess);
  state.position = position;
  state.velocity = state.velocity + dt / 2 * (before + after);
}

/// The step of rk4(), in place. \ingroup motion
/// \tparam V a number or a vector of fixed size
/// \tparam Force called as acceleration(time, position, velocity), answers a V
/// \param state is changed to that after the step
/// \param time at the start [s] \param dt length of the step [s]
/// \param acceleration a(t, x, v) [m/s^2]
template <class V, class Force>
void rk4Step(FixedState<V>& state, Real time, Real dt, Force&& acceleration) {
  const V x = state.position, v = state.velocity;
  const V a1 = acceleration(time, x, v);
  const V x2 = x + dt / 2 * v, v2 = v + dt / 2 * a1;
  const V a2 = acceleration(time + dt / 2, x2, v2);
  const V x3 = x + dt / 2 * v2, v3 = v + dt / 2 * a2;
  const V a3 = acceleration(time + dt / 2, x3, v3);
  const V x4 = x + dt * v3, v4 = v + dt * a3;
  const V a4 = acceleration(time + dt, x4, v4);
  const V sumX = v + 2 * v2 + 2 * v3 + v4, sumV = a1 + 2 * a2 + 2 * a3 + a4;
  state.position = x + dt / 6 * sumX;
  state.velocity = v + dt / 6 * sumV;
}

}  // namespace carom
