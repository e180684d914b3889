#pragma once
// Four ways to hold up a tower: how often does each go through it?
//
// A tower that gravity has pulled for a moment is brought to rest by sweeps, by sweeps that remember
// a direction, by a shock from the ground up, and by Newton's method, all of them cold.
// Why speeds are looked at: they are what one sees, and a shock propagates no forces.
// Not handled: that passes do not cost the same.

#include <string>
#include <vector>

#include "carom/solver/box_column.hpp"

namespace carom {

/// What one way came to. \ingroup solver
struct WayResult {
  std::string name;          ///< of the way
  int passes = 0;            ///< through the tower, until it is slow enough
  Real ground = 0;           ///< impulse that the ground has given then [N s]
  std::vector<Real> speeds;  ///< of the fastest box: at the start, and after each pass [m/s]
};

/// Solves a tower in four ways.
/// \param column as gravity has left it, no impulses given \param slow speed at which to stop [m/s]
/// \return one result for each way; those that are not done after 100,000 passes have given up
/// \ingroup solver
std::vector<WayResult> manyWays(const BoxColumn& column, Real slow);

}  // namespace carom
