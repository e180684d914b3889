#pragma once
// How is a body stepped that turns freely but for a torque, such as a top on its point?
//
// Method: as a particle is: let it turn freely, kick its angular velocity by the torque there, let
// it turn again. A round body turns freely without error, so composing such steps with the lengths
// of composition.hpp gives any order that they give; the energy swings and does not drift.
// Why: the fast spin, which forces other methods to short steps, costs nothing here. Only the slow
// change of the torque has to be followed.
// Source: Hairer, Lubich and Wanner, Geometric Numerical Integration, 2006, VII.5 and V.3; Blanes
// and Moan 2002 (splitting.hpp). The energy of a rotation is a square of L as that of a motion is
// one of the velocity, so their methods keep their order here.
// Not handled: torques that depend on the angular velocity; and, other than round bodies, orders
// beyond four: the free rotation of a body of three unlike moments is followed to order four.

#include <span>

#include "carom/motion/rk4_rotor.hpp"
#include "carom/motion/split_rotor.hpp"
#include "carom/motion/splitting.hpp"

namespace carom {

/// One composed step of a body under torque.
/// \param body steps the free rotation
/// \param state attitude and angular velocity at the start
/// \param time at the start [s]
/// \param dt length of the step; negative runs backwards [s]
/// \param weights lengths of the parts in units of dt, for example kYoshida6Weights
/// \param torque tau(t, state) about the centre of mass, or the fixed point that the moments are
/// about; not dependent on the angular velocity [N m, body]
/// \return attitude and angular velocity at time + dt
/// \throws InvalidInput if a number is not finite, the quaternion not of norm one, or the torque
/// missing
/// \ingroup motion
RotorState kickedRotor(const SplitRotor& body, const RotorState& state, Real time, Real dt,
                       std::span<const Real> weights, const Torque& torque);

/// Many steps of a body under torque by a splitting whose turns and kicks are of free lengths: for
/// the same error a third of the torques, or fewer.
/// \param body steps the free rotation
/// \param state attitude and angular velocity at the start
/// \param time at the start [s]
/// \param dt length of a step; negative runs backwards [s]
/// \param count how many steps, zero or more
/// \param method the lengths, for example kBlanesMoan6
/// \param torque tau(t, state) about the centre of mass, or the fixed point that the moments are
/// about; not dependent on the angular velocity [N m, body]
/// \return attitude and angular velocity at time + count * dt
/// \throws InvalidInput if a number is not finite, the quaternion not of norm one, the torque
/// missing, or the count negative
/// \ingroup motion
RotorState kickedRotor(const SplitRotor& body, const RotorState& state, Real time, Real dt,
                       int count, const Splitting& method, const Torque& torque);

/// Many steps of a body under torque by extrapolation (extrapolation.hpp): for eight digits or more
/// with the fewest torques. Exact for what turns freely, order 2 m for the torque; not symplectic.
/// \param body steps the free rotation
/// \param state attitude and angular velocity at the start
/// \param time at the start [s]
/// \param dt length of a step; negative runs backwards [s]
/// \param count how many steps, zero or more
/// \param answers m, from 1 to kMostAnswers; each step takes m (m + 1) / 2 torques
/// \param torque tau(t, state) about the centre of mass, or the fixed point that the moments are
/// about; not dependent on the angular velocity [N m, body]
/// \return attitude and angular velocity at time + count * dt
/// \throws InvalidInput if a number is not finite, the quaternion not of norm one, the torque
/// missing, or one of the counts out of its range
/// \ingroup motion
RotorState extrapolatedRotor(const SplitRotor& body, const RotorState& state, Real time, Real dt,
                             int count, int answers, const Torque& torque);

}  // namespace carom
