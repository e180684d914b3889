#pragma once
// How are ten thousand bodies stepped for the price of reading and writing them once?
//
// Method: one coordinate of all bodies in one array, and the step in place. Nothing is asked of the
// system, nothing is called for a single body, and the compiler makes two or more bodies at once of
// it.
// Why: a body in free fall costs three sums. What is left is the traffic with the memory, which a
// mere copy has too.
// Not handled: forces between the bodies; for these the two halves of velocity Verlet stand here,
// and what fills the accelerations in between is the caller's.

#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// One step of velocity Verlet for one coordinate of many bodies that nothing acts on, or all the
/// same: exact, and bit by bit what velocityVerlet() does.
/// \param positions of the bodies, changed in place [m]
/// \param velocities of the bodies, changed in place [m/s]
/// \param acceleration of all of them along this coordinate [m/s^2]
/// \param dt length of the step [s]
/// \throws InvalidInput if there are more positions than velocities or fewer, or the acceleration or
/// dt is not finite; the arrays are unchanged
/// \ingroup motion
void stepFalling(std::span<Real> positions, std::span<Real> velocities, Real acceleration, Real dt);

/// The first half of a step of velocity Verlet: half a kick, and the drift.
/// \param positions of the bodies, changed to those after the step [m]
/// \param velocities of the bodies, changed to those in its middle [m/s]
/// \param accelerations at the old positions [m/s^2]
/// \param dt length of the step [s]
/// \throws InvalidInput if the arrays differ in length, or dt is not finite; they are unchanged
/// \ingroup motion
void beginSteps(std::span<Real> positions, std::span<Real> velocities,
                std::span<const Real> accelerations, Real dt);

/// The second half of a step of velocity Verlet: the other half of the kick.
/// \param velocities in the middle of the step, changed to those after it [m/s]
/// \param accelerations at the new positions [m/s^2]
/// \param dt length of the step [s]
/// \throws InvalidInput if the arrays differ in length, or dt is not finite; they are unchanged
/// \ingroup motion
void endSteps(std::span<Real> velocities, std::span<const Real> accelerations, Real dt);

}  // namespace carom
