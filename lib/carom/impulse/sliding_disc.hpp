#pragma once
// How does a disc come to rest that slides and spins at once?
//
// Every part of the disc is braked against its own slip. Where the disc spins fast, the slips of
// opposite parts nearly cancel, so friction brakes its flight less; where it flies fast, it brakes
// the spin less. The two end together, always, and always with the same ratio of speed to rim
// speed.
// Method: with x = v/(R w) the force is mu N F(x) and the torque mu N R T(x), where F and T are
// complete elliptic integrals, found by the arithmetic-geometric mean. The motion follows from one
// equation for x as the spin falls, integrated in the logarithm of the spin.
// Why: it shows that friction of sliding and of spinning are one thing, coupled. A model that
// brakes each by itself stops them at different times.
// Source: Farkas, Bartels, Unger and Wolf, Physical Review Letters 90 (2003) 248302.
// Not handled: pressure that is not even, because a braked disc presses harder in front.

#include "carom/core/real.hpp"

namespace carom {

/// Friction of a disc in parts of what it can be at most. \ingroup impulse
struct DiscFriction {
  Real force = 0;   ///< of mu N, against the flight; 1 without spin [1]
  Real torque = 0;  ///< of mu N R, against the spin; 2/3 without flight [1]
};

/// Friction of a disc that slides and spins.
/// \param ratio speed over rim speed, v/(R w); zero or positive, also infinite [1]
/// \return force and torque
/// \throws InvalidInput if the ratio is negative or NaN
/// \erratum{6.19}
/// \ingroup impulse
DiscFriction discFriction(Real ratio);

/// A disc on a level table. \ingroup impulse
struct SlidingDisc {
  Real speed = 0;       ///< v, zero or positive [m/s]
  Real spin = 0;        ///< w, zero or positive [rad/s]
  Real radius = 1;      ///< R, positive [m]
  Real friction = 0.5;  ///< mu, positive [1]
  Real gravity = 9.81;  ///< positive [m/s^2]
};

/// How a disc came to rest. \ingroup impulse
struct DiscStop {
  Real time = 0;      ///< until it rests [s]
  Real distance = 0;  ///< that it slides, along a straight line [m]
  Real angle = 0;     ///< by which it turns [rad]
  Real ratio = 0;     ///< v/(R w) just before it rests; infinite if it never spun [1]
};

/// How a disc of even thickness comes to rest.
/// \param disc how it starts
/// \return time, distance and angle, right to about ten digits
/// \throws InvalidInput if a number is not finite or out of the range named in SlidingDisc
/// \erratum{6.19}
/// \ingroup impulse
DiscStop stopOfDisc(const SlidingDisc& disc);

}  // namespace carom
