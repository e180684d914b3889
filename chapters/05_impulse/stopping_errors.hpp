#pragma once
// How wrong is the place where a sliding crate stops, if time goes in steps?
//
// Method: slide a crate over a level floor. In each step friction gives its impulse, no more than
// stops the crate, and then the crate moves with its new velocity. Compare where it comes to rest
// with the exact v^2 / (2 mu g).
// Why the new velocity: this is the order in which the engines of the later chapters go. The crate
// moves through each step with the speed that it has at the end, so it falls short.
// Source: section 6.4 of the source text; case I6.
// Not handled: steps that locate the stop (slide_block.hpp).

#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// Gravity on the level floor. \ingroup impulse
inline constexpr Real kFloorGravity = 9.81;  // [m/s^2]

/// Where a crate stops with one length of step. \ingroup impulse
struct StoppingError {
  Real step = 0;      ///< length of a step [s]
  Real distance = 0;  ///< how far the crate has slid when it is at rest [m]
  Real error = 0;     ///< distance minus the exact one: negative if it falls short [m]
};

/// Measures where a sliding crate stops.
/// \param speed at the beginning, positive [m/s]
/// \param friction mu, positive [1]
/// \param steps lengths to try, each positive [s]
/// \return one row for each length, in the order given
/// \throws InvalidInput if a number is not positive and finite
/// \ingroup impulse
std::vector<StoppingError> stoppingErrors(Real speed, Real friction, std::span<const Real> steps);

}  // namespace carom
