#pragma once
// A ball that bounces lower and lower: when is its tenth impact, and when does it lie still?
//
// Method: each flight is e times as long as the one before, so the times of the impacts are sums of
// a geometric series, and infinitely many of them take a finite time. All of them are in closed
// form; the ball then lies still.
// Why: Zeno in earnest. A program that looks for one impact after the other never gets past that
// moment, and one that takes fixed steps misses most of them.
// Source: case book I10.
// Not handled: balls with a size of their own (measure the height from where it touches), air.

#include "carom/core/real.hpp"

namespace carom {

/// A ball above the floor. \ingroup impulse
struct BouncingBall {
  Real height = 0;    ///< of its lowest point, zero or positive [m]
  Real velocity = 0;  ///< upwards [m/s]
};

/// What floor and ball are like. \ingroup impulse
struct BounceLaw {
  Real restitution = 0.8;  ///< e, from 0 to 1 [1]
  Real gravity = 9.81;     ///< positive [m/s^2]
};

/// The time of an impact.
/// \param ball at the start \param law of floor and ball
/// \param number of the impact, from 1
/// \return time from the start [s]
/// \throws InvalidInput if a number is not finite, or out of the range named here
/// \ingroup impulse
Real impactTime(const BouncingBall& ball, const BounceLaw& law, int number);

/// The time at which the ball lies still.
/// \param ball at the start \param law of floor and ball
/// \return time from the start; infinite for e = 1 [s]
/// \throws InvalidInput if a number is not finite, or out of the range named here
/// \ingroup impulse
Real restTime(const BouncingBall& ball, const BounceLaw& law);

/// Where the ball is after a while.
/// \param ball at the start \param law of floor and ball \param time zero or positive [s]
/// \return the ball then; exactly at rest after restTime()
/// \throws InvalidInput if a number is not finite, or out of the range named here
/// \ingroup impulse
BouncingBall bounceBall(const BouncingBall& ball, const BounceLaw& law, Real time);

}  // namespace carom
