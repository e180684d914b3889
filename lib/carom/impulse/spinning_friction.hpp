#pragma once
// Why does a top stop that spins on one spot?
//
// At a single point nothing slips, so a model with one point has no torque, and its top spins for
// ever, as the source says of its own. A real contact is a small patch, and every part of it but
// the middle slips.
// Method: a disc of radius R pressed evenly by N. A ring of radius r carries N 2 r dr/R^2 of the
// pressure and brakes with mu times that at the arm r; all rings together give 2/3 mu N R. Over a
// short time that is an angular impulse of 2/3 mu R jn, which can stop the spin but not reverse it.
// Source: section 6.5, put right; Farkas, Bartels, Unger and Wolf, Physical Review Letters 90
// (2003) 248302.
// Not handled: a patch that also slides, which weakens both frictions (sliding_disc.hpp).

#include "carom/core/real.hpp"

namespace carom {

/// What spinning friction depends on. \ingroup impulse
struct SpinningContact {
  Real spin = 0;           ///< of B against A, about the normal [rad/s]
  Real inertia = 1;        ///< about the normal, positive [kg m^2]
  Real normalImpulse = 0;  ///< zero or positive [N s]
  Real friction = 0;       ///< mu, zero or positive [1]
  Real radius = 0;         ///< of the disc on which the bodies touch, zero or positive [m]
};

/// The angular impulse of friction under a disc that spins on the spot.
/// \param contact rate, pressure and size of the disc
/// \return angular impulse on B about the normal, against the spin; A gets the opposite [N m s]
/// \throws InvalidInput if a number is not finite or out of the range named in SpinningContact
/// \erratum{6.19}
/// \ingroup impulse
Real spinningFriction(const SpinningContact& contact);

}  // namespace carom
