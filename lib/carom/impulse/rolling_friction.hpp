#pragma once
// Why does a ball that rolls on a level table stop at all?
//
// Sliding friction cannot do it: the lowest point of a rolling ball stands still. But ball and
// cloth give way a little, and the table presses mostly in front of the middle. The normal force
// acts there, at a distance b, and turns the ball backwards.
// Method: a torque b N against the rolling; over a short time an angular impulse b jn. It can stop
// the rolling, but not turn it back: at most inertia times rate.
// Why b is a length: it is how far in front of the middle the table presses. Tables list b/R, 0.005
// to 0.015 for billiard balls on cloth.
// Source: Coulomb 1785; the source text leaves rolling friction out.
// Not handled: what the torque does to the sliding at the contact; friction_impulse.hpp, called
// after, sees to that.

#include "carom/core/real.hpp"

namespace carom {

/// What rolling friction depends on. \ingroup impulse
struct RollingContact {
  Vector3 angularVelocity = Vector3::Zero();  ///< of B against A [rad/s, world]
  Vector3 normal = Vector3::UnitZ();          ///< unit, from A to B [1, world]
  Real inertia = 1;        ///< about the axis of rolling through the contact, positive [kg m^2]
  Real normalImpulse = 0;  ///< zero or positive [N s]
  Real arm = 0;            ///< b: how far in front of the middle A presses, zero or positive [m]
};

/// The angular impulse of rolling friction.
/// \param contact rates, pressure and b
/// \return angular impulse on B, perpendicular to the normal and against the rolling; A gets the
/// opposite [N m s, world]
/// \throws InvalidInput if a number is not finite or out of the range named in RollingContact
/// \ingroup impulse
Vector3 rollingFriction(const RollingContact& contact);

}  // namespace carom
