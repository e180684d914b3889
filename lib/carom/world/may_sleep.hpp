#pragma once
// Is a body at rest, or does it only move slowly?
//
// Method: watch it for a while, and compare the two halves of that time. A body that comes to rest
// moves less and less: its second way is much shorter than its first. One that begins to tip is
// just as slow, but its way grows; one that creeps goes on evenly. Rest is: slow, not far, and
// dying out; or so little, in both halves, that only rounding or the sweeps of a solver can be the
// cause, and not growing.
// Why not speed alone: a pencil that stands on its tip begins to fall at no speed at all, and a
// ball is slowest at the top of its flight.
// Source: the idea of a window of time is common (Bullet, Box2D); comparing its halves is ours.
// Not handled: bodies that wait for a push that the world does not know of; wake them.

#include "carom/core/real.hpp"

namespace carom::world {

/// How a body moved while it was watched. Way and speed are those of its farthest point.
/// \ingroup world
struct RestWatch {
  Real firstWay = 0;   ///< in the first half of the time [m]
  Real secondWay = 0;  ///< in the second half [m]
  Real speed = 0;      ///< the fastest in all that time [m/s]
};

/// What counts as rest. \ingroup world
struct RestLimits {
  Real speed = 0.05;     ///< positive [m/s]
  Real distance = 1e-3;  ///< in all the time, positive [m]
  Real noise = 1e-6;     ///< a way that solvers and rounding make, positive [m]
};

/// Whether a body may fall asleep.
/// \param watch how it moved \param limits what counts as rest
/// \return true if it rests
/// \ingroup world
bool maySleep(const RestWatch& watch, const RestLimits& limits);

}  // namespace carom::world
