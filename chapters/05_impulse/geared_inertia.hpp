#pragma once
// How heavy is a train of gears to turn, felt at its first axle?
//
// Method: a gear that turns N1/N times as fast as the first one is felt there with the square of
// that: I1 + I2 (N1/N2)^2 + ...
// Why the square: the ratio counts once for the speed, and once for the lever of the tooth that
// carries the torque. Energy says the same, since it goes with the square of the rate.
// Why no theorem of parallel axes: each gear turns about its own axle, which stands still.
// Source: the note on gears in section 6.1 of the source text, put right.
// Not handled: friction between the teeth, play, and axles that move (planetary gears).

#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// A toothed wheel on an axle that stands still. \ingroup impulse
struct GearWheel {
  int teeth = 1;                   ///< how many, at least 1
  Real inertia = 0;                ///< about its own axle, zero or positive [kg m^2]
  Real mass = 0;                   ///< zero or positive [kg]
  Vector2 axle = Vector2::Zero();  ///< where it stands [m]
};

/// The moment of inertia that the first axle feels, if each gear meshes with the next.
/// \param train the gears in order, at least one
/// \return moment of inertia of the whole train, felt at the first axle [kg m^2]
/// \throws InvalidInput if there is no gear, one has no teeth, or a moment of inertia is negative
/// or not finite
/// \erratum{6.8}
/// \ingroup impulse
Real gearedInertia(std::span<const GearWheel> train);

}  // namespace carom
