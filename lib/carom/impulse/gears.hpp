#pragma once
// Two gears that mesh: how hard are they to turn, and what happens when they are pushed together?
//
// Method: the teeth make the rims move together, so the second gear turns N1/N2 times as fast, and
// whoever turns the first one feels its inertia times the square of that: once for the torque, once
// for the rate. When two turning gears are pushed into mesh, an impulse at the teeth makes their
// rims equal; it has the arm r1 on one and r2 on the other.
// Why not Steiner, as the source notes: his theorem moves the axis of one rigid body. Gears keep
// their axes, and turn at different rates.
// Source: the note in section 6.1, put right.
// Not handled: bevel and worm gears, play between the teeth.

#include "carom/core/real.hpp"

namespace carom {

/// A gear on a fixed axle. \ingroup impulse
struct Gear {
  Real inertia = 1;          ///< about its axle, positive [kg m^2]
  Real radius = 1;           ///< of its pitch circle, positive; as teeth are to teeth [m]
  Real angularVelocity = 0;  ///< counter-clockwise [rad/s]
};

/// The inertia that is felt at the axle of the first of two meshing gears: I1 + I2 (N1/N2)^2.
/// \param inertia1 of the first about its axle, positive [kg m^2]
/// \param teeth1 of the first, at least one
/// \param inertia2 of the second about its axle, positive [kg m^2]
/// \param teeth2 of the second, at least one
/// \return inertia [kg m^2]
/// \throws InvalidInput if an inertia is not positive and finite or a gear has no teeth
/// \erratum{6.8}
/// \ingroup impulse
Real meshedInertia(Real inertia1, int teeth1, Real inertia2, int teeth2);

/// Pushes two gears into mesh, side by side: afterwards their rims move together.
/// \param first its angular velocity is changed
/// \param second its angular velocity is changed
/// \return the impulse at the teeth; the same size turns both, each by its radius [N s]
/// \throws InvalidInput if an inertia or radius is not positive and finite, or a rate not finite;
/// the gears are then unchanged
/// \erratum{6.8}
/// \ingroup impulse
Real meshGears(Gear& first, Gear& second);

}  // namespace carom
