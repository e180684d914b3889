#pragma once
// Other ways to find the first contact of two features, for the suite `toi`: what one would write
// first, and how each fails.

#include <optional>

#include "carom/toi/moving_points.hpp"

namespace carom::bench {

/// The roots of the cubic in doubles, and an inside test with a tolerance (Provot 1997). Drops
/// contacts whose cubic vanishes, invents some within the tolerance, and is late by rounding.
/// \param tolerance of the weights of the corners, or of the places along the edges [1]
std::optional<Real> cubicWithTolerance(FeaturePair pair, const MovingPoints& points,
                                       Real tolerance);

/// Steps as long as the distance between the features allows, until they are nearer than a
/// tolerance. Never late; what comes near without touching counts as a hit, and slow approaches
/// take many steps.
/// \param tolerance distance at which it stops [m] \param limit number of steps after which it
///   stops too, and says hit
std::optional<Real> advanceFeatures(FeaturePair pair, const MovingPoints& points, Real tolerance,
                                    int limit);

}  // namespace carom::bench
