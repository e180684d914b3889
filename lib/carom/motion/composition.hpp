#pragma once
// How is a method of high order made from one of order two?
//
// Method: make several steps of Verlet's, of lengths w1 h, w2 h, ... that add up to h, some of them
// backwards. The lengths are chosen such that the errors of third, fifth, ... order cancel. Between
// two steps the drifts join: drift, kick, drift, kick, ..., drift.
// Why: the result stays symplectic and time-reversible, so energy does not drift however long the
// run, and it needs nothing but the force. Three steps give order 4, seven order 6.
// Source: Yoshida, Physics Letters A 150, 1990; the digits of order 6 (his solution A) are those of
// Hairer, Lubich and Wanner 2006, V.3.2; Kahan and Li, Mathematics of Computation 66, 1997.
// Not handled: forces that depend on the velocity (the kick would have to be solved for), and
// changing the step on the way, which would lose what the method is for.

#include <array>
#include <span>

#include "carom/core/real.hpp"
#include "carom/motion/careful_sum.hpp"

namespace carom {

/// Verlet alone: order 2, one force a step. \ingroup motion
inline constexpr std::array<Real, 1> kVerletWeights = {1};

/// Yoshida's order 4, three forces a step: 1/(2 - c), -c/(2 - c), 1/(2 - c) with c the cube root of
/// 2.
/// \ingroup motion
inline constexpr std::array<Real, 3> kYoshida4Weights = {
    1.35120719195965763405, -1.70241438391931526810, 1.35120719195965763405};

/// Yoshida's order 6, seven forces a step. \ingroup motion
inline constexpr std::array<Real, 7> kYoshida6Weights = {
    0.784513610477557263820, 0.235573213359358133685, -1.17767998417887100695,
    1.31518632068391121888,  //
    -1.17767998417887100695, 0.235573213359358133685, 0.784513610477557263820};

/// Kahan and Li's order 6, nine forces a step, and a tenth of the error of Yoshida's or less.
/// \ingroup motion
inline constexpr std::array<Real, 9> kKahanLi6Weights = {
    0.39216144400731413928,  0.33259913678935943860, -0.70624617255763935981,
    0.082213596293550800230, 0.79854399093482996340, 0.082213596293550800230,
    -0.70624617255763935981, 0.33259913678935943860, 0.39216144400731413928};

/// Kahan and Li's order 8, seventeen forces a step. \ingroup motion
inline constexpr std::array<Real, 17> kKahanLi8Weights = {
    0.130202483088890080879,  0.561162981775108384562,  -0.389474962644847286408,
    0.158841906555155600896,  -0.395903894133237577336, 0.184539640978315707092,
    0.258374387686322047294,  0.295011723609310298871,  -0.605508533830034511699,
    0.295011723609310298871,  0.258374387686322047294,  0.184539640978315707092,
    -0.395903894133237577336, 0.158841906555155600896,  -0.389474962644847286408,
    0.561162981775108384562,  0.130202483088890080879};

/// One composed step, in place. It allocates nothing that `acceleration` does not, so it also
/// serves large systems.
/// \tparam V a number or a vector: anything that can be multiplied by a Real and added
/// \tparam Force called as acceleration(time, position), answers something that converts to V
/// \param position at the start; is changed to that at the end [m]
/// \param velocity at the start; is changed to that at the end [m/s]
/// \param time at the start [s]
/// \param dt length of the step; negative runs backwards [s]
/// \param weights lengths of the parts in units of dt, adding up to 1, for example kYoshida4Weights
/// \param acceleration a(t, x) [m/s^2]
/// \ingroup motion
template <class V, class Force>
void composedStep(V& position, V& velocity, Real time, Real dt, std::span<const Real> weights,
                  Force&& acceleration) {
  Real drift = 0, done = 0;  // what of the drift is owed, and how far the kicks have come [1]
  for (const Real w : weights) {
    drift += w / 2;
    position += drift * dt * velocity;
    velocity += w * dt * acceleration(time + (done + w / 2) * dt, position);
    drift = w / 2;
    done += w;
  }
  position += drift * dt * velocity;
}

/// A motion that remembers what rounding has taken from it. \ingroup motion
template <class V>
struct CarefulMotion {
  V position;      ///< [m]
  V velocity;      ///< [m/s]
  V lostPosition;  ///< what rounding has lost of the position; zero at the start [m]
  V lostVelocity;  ///< what rounding has lost of the velocity; zero at the start [m/s]
};

/// The same step with every sum compensated: what rounding cuts off is added to the next term.
/// After n steps the error of rounding is that of a few, where the plain step has n (and n^1.5 in
/// the phase). It costs a few additions, which wait for nothing.
/// \tparam V a number or a vector of fixed size
/// \tparam Force called as acceleration(time, position), answers something that converts to V
/// \param motion at the start; is changed to that at the end
/// \param time at the start [s]
/// \param dt length of the step; negative runs backwards [s]
/// \param weights lengths of the parts in units of dt, adding up to 1, for example kYoshida4Weights
/// \param acceleration a(t, x) [m/s^2]
/// \ingroup motion
template <class V, class Force>
void composedStep(CarefulMotion<V>& motion, Real time, Real dt, std::span<const Real> weights,
                  Force&& acceleration) {
  Real drift = 0, done = 0;
  for (const Real w : weights) {
    drift += w / 2;
    addCarefully<V>(motion.position, motion.lostPosition, drift * dt * motion.velocity);
    addCarefully<V>(motion.velocity, motion.lostVelocity,
                    w * dt * acceleration(time + (done + w / 2) * dt, motion.position));
    drift = w / 2;
    done += w;
  }
  addCarefully<V>(motion.position, motion.lostPosition, drift * dt * motion.velocity);
}

}  // namespace carom
