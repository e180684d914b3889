#pragma once
// The listings of sections 7.2 and 7.3 of the source, behind this chapter's interface, to be seen
// failing.

#include "carom/motion/state.hpp"

//! [verlet]
// Section 7.2, "Verlet": the velocity makes a step of explicit Euler.
inline carom::State sourceVerlet(const carom::State& now, carom::Real t,
                                 carom::Real dt,
                                 const carom::Acceleration& force) {
  const auto& [s, v] = now;
  const carom::Coordinates a = force(t, s, v);
  return {s + v * dt + 0.5 * a * dt * dt, v + a * dt};
}
//! [verlet]

//! [velocity_verlet]
// Section 7.3, "Velocity Verlet", with s for the x that is not there:
// nobody asks for the force at s_new, so a_new is a.
inline carom::State sourceVelocityVerlet(const carom::State& now,
                                         carom::Real t, carom::Real dt,
                                         const carom::Acceleration& force) {
  const auto& [s, v] = now;
  const carom::Coordinates a = force(t, s, v);
  const carom::Coordinates s_new = s + v * dt + a * (dt * dt * 0.5);
  const carom::Coordinates a_new = force(t, s, v);
  return {s_new, v + (a + a_new) * (dt * 0.5)};
}
//! [velocity_verlet]

//! [runge_kutta]
// Section 7.4, with k2 in the last line where k3 belongs.
inline carom::State sourceRungeKutta(const carom::State& x, carom::Real t,
                                     carom::Real h,
                                     const carom::Acceleration& a) {
  const auto f = [&](carom::Real time, const carom::State& y) {
    return carom::State{y.velocity, a(time, y.position, y.velocity)};
  };
  const auto plus = [&](carom::Real dt, const carom::State& k) {
    return carom::State{x.position + dt * k.position,
                        x.velocity + dt * k.velocity};
  };
  const carom::State k1 = f(t, x);
  const carom::State k2 = f(t + h / 2, plus(h / 2, k1));
  const carom::State k3 = f(t + h / 2, plus(h / 2, k2));
  const carom::State k4 = f(t + h, plus(h, k2));
  return {x.position + h / 6 * (k1.position + 2 * k2.position +
                                2 * k3.position + k4.position),
          x.velocity + h / 6 * (k1.velocity + 2 * k2.velocity +
                                2 * k3.velocity + k4.velocity)};
}
//! [runge_kutta]

//! [old_velocity]
// Velocity Verlet, asking for the force at the new place and the old
// velocity. Without air nobody notices.
inline carom::State withOldVelocity(const carom::State& now, carom::Real t,
                                    carom::Real dt,
                                    const carom::Acceleration& force) {
  const auto& [s, v] = now;
  const carom::Coordinates a = force(t, s, v);
  const carom::Coordinates s_new = s + v * dt + a * (dt * dt * 0.5);
  const carom::Coordinates a_new = force(t + dt, s_new, v);
  return {s_new, v + (a + a_new) * (dt * 0.5)};
}
//! [old_velocity]
