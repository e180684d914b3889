#pragma once
// How does the air brake a body?
//
// Method: F = -1/2 rho C_D A |w| w, where w is the velocity against the air. A body that meets
// twice the speed meets twice as much air per second, and twice as fast.
// Why |w| w and not a square: a square has lost the direction. With it a body that is thrown
// upwards against gravity would be pushed on. And why w: in a wind, a body at rest is pushed along.
// Source: equation 34, which has a coefficient too many and no direction, put right.
// Not handled: how the area depends on the direction (projected_area.hpp), lift, and slow motion in
// honey, which goes with the first power of the speed.

#include "carom/core/real.hpp"

namespace carom {

/// The air around a body, and what the body offers to it. \ingroup impulse
struct AirDrag {
  Vector3 wind = Vector3::Zero();  ///< velocity of the air [m/s, world]
  Real density = 1.225;            ///< of the air, zero or positive; at sea level [kg/m^3]
  Real coefficient = 0.47;         ///< C_D, zero or positive; of a ball [1]
  Real area = 1;                   ///< seen along the flow, zero or positive [m^2]
};

/// The force of the air on a body.
/// \param velocity of the body [m/s, world]
/// \param air wind, density, coefficient and area
/// \return force, against the motion relative to the air [N, world]
/// \throws InvalidInput if a number is not finite, or density, coefficient or area negative
/// \source{34}
/// \erratum{6.10}
/// \ingroup impulse
Vector3 dragForce(const Vector3& velocity, const AirDrag& air);

}  // namespace carom
