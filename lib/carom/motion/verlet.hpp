#pragma once
// Where is everything next, if we know where it was at two moments?
//
// Method: x(i+1) = 2 x(i) - x(i-1) + a(x(i)) dt^2. The two velocities that would be needed cancel.
// Why: one force per step, order 2, no drift of the energy, and the same formula runs backwards:
// swap the two positions. It does run forwards, other than the source says.
// Source: Störmer 1907, for particles in the aurora; Verlet, Physical Review 159, 1967, for
// molecules (the source says projectiles); Newton's Principia, by the account of Hairer, Lubich and
// Wanner, Acta Numerica 12, 2003. The listing of section 7.2 is another method: Taylor for the
// position and explicit Euler for the velocity, of first order, and it explodes.
// Not handled: forces that depend on the velocity. The function is given (x(i) - x(i-1)) / dt, half
// a step late, which lowers the order to one. Each step rounds a difference of two near positions,
// so over n steps rounding grows like n^2 where velocity_verlet.hpp has n.

#include "carom/motion/state.hpp"

namespace carom {

/// Two moments of a motion, a step apart. \ingroup motion
struct TwoPositions {
  Coordinates previous;  ///< n x 1, one step ago [m]
  Coordinates current;   ///< n x 1, now [m]
};

/// One step of the method of Störmer and Verlet. Order 2; energy does not drift.
/// \param positions one step ago, and now
/// \param time now [s]
/// \param dt length of this step and of the one before; not zero, negative runs backwards [s]
/// \param acceleration a(t, x, v), not dependent on v
/// \return the positions now, and one step on
/// \throws InvalidInput if a number is not finite, dt is zero, or the counts of positions and
/// accelerations differ
/// \erratum{7.4,7.5,7.6}
/// \ingroup motion
TwoPositions verlet(const TwoPositions& positions, Real time, Real dt,
                    const Acceleration& acceleration);

}  // namespace carom
