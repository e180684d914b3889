#pragma once
// How does a ball that slides begin to roll?
//
// Method: friction brakes the slip of the lowest point, u = v + w x (-R z), with mu g against its
// direction. Both flight and spin follow, in a fixed proportion, so the slip keeps its direction
// and falls evenly; the ball runs along a parabola. At t = |u|/(mu g (1 + 1/k)) the slip is gone,
// and the ball rolls straight on with v0 - k/(1 + k) u0, whatever mu was: 5/7 v0 for a solid ball
// that did not spin. The moment is computed, not stepped over, so the result is right to rounding
// for any step.
// Why not step: a step that reaches over the moment is wrong by the square of the step, and
// friction along x and y by itself (a box instead of a cone) sends a massé shot the wrong way.
// Source: Coriolis 1835; case book I7, I7b, I15.
// Not handled: rolling friction, cushions and slopes.

#include "carom/core/real.hpp"

namespace carom {

/// A ball on a level table, z up. \ingroup impulse
struct TableBall {
  Vector2 position = Vector2::Zero();         ///< of its centre over the table [m]
  Vector2 velocity = Vector2::Zero();         ///< along the table [m/s]
  Vector3 angularVelocity = Vector3::Zero();  ///< spin about z is left as it is [rad/s]
};

/// What a ball and its table are like. \ingroup impulse
struct TableLaw {
  Real radius = 1;      ///< R, positive [m]
  Real friction = 0.2;  ///< mu, zero or positive [1]
  Real gravity = 9.81;  ///< positive [m/s^2]
  Real gyration = 0.4;  ///< k in I = k m R^2: 2/5 for a solid ball, 2/3 hollow; positive [1]
};

/// How fast the lowest point of the ball slips over the table.
/// \param ball on the table \param law radius \return slip [m/s]
/// \ingroup impulse
Vector2 slipOf(const TableBall& ball, const TableLaw& law);

/// When the ball rolls.
/// \param ball at the start \param law of ball and table
/// \return time from the start; 0 if it rolls, infinite if there is no friction to make it roll [s]
/// \throws InvalidInput if a number is not finite, or out of the range named in TableLaw
/// \ingroup impulse
Real timeToRoll(const TableBall& ball, const TableLaw& law);

/// Where the ball is after a while, and how it moves.
/// \param ball at the start \param law of ball and table \param time zero or positive [s]
/// \return the ball then; once it rolls, its velocity does not change any more
/// \throws InvalidInput if a number is not finite, or out of the range named here
/// \ingroup impulse
TableBall rollBall(const TableBall& ball, const TableLaw& law, Real time);

}  // namespace carom
