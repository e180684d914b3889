#pragma once
// How does a method that wants two positions begin, and what is the velocity?
//
// Method: the position a step ago by Taylor, x - v dt + a dt^2/2, which is right to dt^3 and so
// keeps the order; the velocity is the mean over the two steps around a moment, right to dt^2.

#include "carom/motion/verlet.hpp"

namespace carom {

/// The two positions from which verlet() starts.
/// \param state positions and velocities now
/// \param time now [s]
/// \param dt length of the steps to come; not zero [s]
/// \param acceleration a(t, x, v)
/// \return the positions one step ago, and now
/// \throws InvalidInput if a number is not finite, dt is zero, or the counts of positions,
/// velocities and accelerations differ
/// \ingroup motion
TwoPositions verletStart(const State& state, Real time, Real dt, const Acceleration& acceleration);

/// Position and velocity at the later of two moments of a motion by verlet().
/// \param positions one step ago, and now
/// \param time now [s]
/// \param dt length of the steps; not zero [s]
/// \param acceleration a(t, x, v), not dependent on v
/// \return positions and velocities now, the velocities to order 2
/// \throws InvalidInput as verlet()
/// \ingroup motion
State verletState(const TwoPositions& positions, Real time, Real dt,
                  const Acceleration& acceleration);

}  // namespace carom
