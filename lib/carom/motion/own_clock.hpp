#pragma once
// How does a planet take short steps near the sun without losing what Verlet keeps?
//
// Method: let the steps be even in a clock of the system's own, which runs fast where the potential
// is deep: ds = U dt, with U the work that it takes to pull everything apart. In this clock the
// equations come from the energy log(T + B) - log(U), T the energy of motion and B that of binding.
// Both parts can be done exactly: a drift for the time h / (T + B), in which T does not change, and
// a kick by the force times h / U. Taking turns is Verlet's step with a clock, and composes with
// the lengths of composition.hpp to any order.
// Why: steps that are chosen by the error lose what symplectic methods are for, and equal steps in
// time are far too short for a comet's slow years. These are both: equal, and short near the sun.
// For two bodies each step lies on the true orbit, and only its time is wrong.
// Source: Mikkola and Tanikawa, Celestial Mechanics and Dynamical Astronomy 74, 1999; Preto and
// Tremaine, Astronomical Journal 118, 1999.
// Not handled: forces without a potential, potentials that push (U <= 0), and a system that a force
// from outside gives energy.

#include <algorithm>
#include <cmath>
#include <span>

#include "carom/core/checks.hpp"
#include "carom/core/real.hpp"
#include "carom/motion/careful_sum.hpp"

namespace carom {

/// What a place is worth. \tparam V a vector of fixed size \ingroup motion
template <class V>
struct Pull {
  V acceleration;      ///< a, the slope of `potential` [m/s^2]
  Real potential = 0;  ///< U, work per mass to get away from here, positive [m^2/s^2]
};

/// A motion with a clock, and what rounding has taken from it. \tparam V a vector of fixed size
/// \ingroup motion
template <class V>
struct ClockedMotion {
  V position;                  ///< [m]
  V velocity;                  ///< [m/s]
  Real time = 0;               ///< [s]
  Real binding = 0;            ///< B = U - T, of the start; bindingOf() [m^2/s^2]
  V lostPosition = V::Zero();  ///< [m]
  V lostVelocity = V::Zero();  ///< [m/s]
  Real lostTime = 0;           ///< [s]
};

/// A motion that begins at time zero.
/// \tparam V a vector of fixed size
/// \tparam Field called as field(position), answers a Pull<V>
/// \param position [m] \param velocity [m/s] \param field what pulls
/// \return the motion with its binding energy
/// \ingroup motion
template <class V, class Field>
ClockedMotion<V> withClock(const V& position, const V& velocity, Field&& field) {
  ClockedMotion<V> motion;
  motion.position = position;
  motion.velocity = velocity;
  motion.binding = field(position).potential - velocity.squaredNorm() / 2;
  motion.lostPosition = motion.lostVelocity = V::Zero();
  return motion;
}

/// One composed step of the system's own clock, sums compensated.
/// \tparam V a vector of fixed size
/// \tparam Field called as field(position), answers a Pull<V>
/// \param motion is changed to that after the step
/// \param ds length of the step: of the integral of U dt; negative runs backwards [m^2/s]
/// \param weights lengths of the parts in units of ds, for example kKahanLi8Weights
/// \param field what pulls
/// \ingroup motion
template <class V, class Field>
void clockedStep(ClockedMotion<V>& motion, Real ds, std::span<const Real> weights, Field&& field) {
  const auto drift = [&](Real h) {
    const Real dt = h / (motion.velocity.squaredNorm() / 2 + motion.binding);
    addCarefully(motion.time, motion.lostTime, dt);
    addCarefully<V>(motion.position, motion.lostPosition, dt * motion.velocity);
  };
  Real owed = 0;
  for (const Real w : weights) {
    drift((owed + w / 2) * ds);
    const Pull<V> pull = field(motion.position);
    addCarefully<V>(motion.velocity, motion.lostVelocity,
                    w * ds / pull.potential * pull.acceleration);
    owed = w / 2;
  }
  drift(owed * ds);
}

/// Follows a motion to a time: steps of `ds`, and at the end a few shorter ones that meet it.
/// \tparam V a vector of fixed size
/// \tparam Field called as field(position), answers a Pull<V>
/// \param motion is changed to that at the end
/// \param end when to stop; not before motion.time [s]
/// \param ds length of the steps, positive [m^2/s]
/// \param weights lengths of the parts in units of ds, for example kKahanLi8Weights
/// \param field what pulls
/// \throws InvalidInput if the end is not finite or ds not positive and finite
/// \ingroup motion
template <class V, class Field>
void followToTime(ClockedMotion<V>& motion, Real end, Real ds, std::span<const Real> weights,
                  Field&& field) {
  requireFinite(end, "end");
  requirePositive(ds, "ds");
  const auto left = [&] { return (end - motion.time) - motion.lostTime; };
  // U without a look at the field: it is T + B.
  const auto wanted = [&] { return left() * (motion.velocity.squaredNorm() / 2 + motion.binding); };
  while (wanted() > ds) clockedStep(motion, ds, weights, field);
  // Newton's method for the length of the last step: U is the slope of s over t, and each try
  // begins where the last one ended. It ends when the clock cannot be set more finely.
  constexpr int kMostTries = 30;
  for (int i = 0; i < kMostTries && std::abs(left()) > 1e-16 * std::abs(end); ++i) {
    clockedStep(motion, std::clamp(wanted(), -ds, ds), weights, field);
  }
}

}  // namespace carom
