#pragma once
// Where will a top in free fall point in an hour?
//
// Method: a body with two equal moments needs no steps. It turns steadily about its angular
// momentum L, at |L| / I_across, and steadily about its own axis, so its attitude is the product of
// two rotations:
//   q(t) = exp(L t / (2 I_across)) q(0) exp(e3 w3 (1 - I_along / I_across) t / 2),
// and its angular velocity goes round the axis in the body at the last of these rates, backwards.
// Why: any time in one evaluation, with no error but rounding. Everything that steps can be
// measured against it.
// Source: Euler's equation with I1 = I2 (equation 16); Landau and Lifshitz, Mechanics, section 36.
// Note that the difference of the moments is divided once: taking two nearly equal rates from each
// other would lose the digits that a nearly spherical body needs.
// Not handled: three unlike moments (free_rotor.hpp), and torque.

#include "carom/motion/rotor.hpp"

namespace carom {

/// The moments of a body that is round about its z axis. \ingroup motion
struct RoundMoments {
  Real across = 1;  ///< about x and about y, positive [kg m^2]
  Real along = 1;   ///< about z, positive [kg m^2]
};

/// The free rotation of a body that is round about its z axis.
/// \param moments across and along the axis
/// \param start attitude and angular velocity at time zero
/// \param time any time, also before [s]
/// \return attitude and angular velocity at that time
/// \throws InvalidInput if a number is not finite, a moment not positive, or the quaternion not of
/// norm one
/// \ingroup motion
RotorState exactRotor(const RoundMoments& moments, const RotorState& start, Real time);

}  // namespace carom
