#pragma once
// What does a simulation know about a thing that moves, and what does it ask about the forces?
//
// Method: a list of coordinates, a list of their velocities, and a function that answers with the
// accelerations. One coordinate is a falling ball, two are a planet, three times ten thousand are a
// gas. Every method of this chapter takes the state, the time, the step and that function, and
// returns the state a step later; so one can be exchanged for another by changing one word.
// Why the function is given time and velocity too: the sun moves and air brakes. A method that
// cannot use them says so.
// A first-order equation y' = f(t, y) fits in: let y be the velocity and f the acceleration.
// Not handled: rotations, which are no list of coordinates (rotor.hpp).

#include <functional>

#include "carom/core/real.hpp"

/// \defgroup motion Integrators and free rotation: chapter 6
/// How positions, velocities and attitudes follow from forces.

namespace carom {

/// A column of as many numbers as the system has coordinates. \ingroup motion
using Coordinates = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// Where everything is and how it moves. \ingroup motion
struct State {
  Coordinates position;  ///< n x 1 [m, or rad for an angle]
  Coordinates velocity;  ///< n x 1 [m/s, or rad/s]
};

/// Answers a(t, x, v): the accelerations [n x 1, m/s^2] at a time [s], for positions [n x 1, m] and
/// velocities [n x 1, m/s]. Of a body that is the sum of all forces on it over its mass. A lambda
/// should name its return type: `-> Coordinates`.
/// \source{12} \ingroup motion
using Acceleration =
    std::function<Coordinates(Real time, const Coordinates& position, const Coordinates& velocity)>;

/// Asks for the accelerations, and sees to it that there is one for each coordinate.
/// \param acceleration the function to ask
/// \param time when [s]
/// \param position n x 1 [m]
/// \param velocity n x 1 [m/s]
/// \return n x 1 [m/s^2]
/// \throws InvalidInput if there is no function, or it answers with another number of components
/// \ingroup motion
Coordinates accelerationAt(const Acceleration& acceleration, Real time, const Coordinates& position,
                           const Coordinates& velocity);

/// Refuses a state and a step that cannot be worked with.
/// \param state any state
/// \param time any time [s]
/// \param dt any step; negative runs backwards [s]
/// \throws InvalidInput if a number is not finite, or there are more positions than velocities or
/// fewer
/// \ingroup motion
void requireUsable(const State& state, Real time, Real dt);

}  // namespace carom
