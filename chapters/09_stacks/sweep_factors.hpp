#pragma once
// By what factor does a sweep over a stack make the error smaller?
//
// Method: a column of n equal boxes that has just been pulled by gravity. After n^2 sweeps only the
// slowest part of the error is left; one more sweep, and the errors of the impulse at the ground
// before and after it are compared.
// Why there: the row at the ground carries all, and hears of the top last.
// Source: Young 1954: Gauss and Seidel's factor is the square of Jacobi's, here cos^2(pi / 2n).
// Not handled: one box, which is right after a single visit.

#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// What was measured of a column. \ingroup solver
struct SweepFactor {
  int boxes = 0;    ///< in the column
  Real factor = 0;  ///< of the error, from one sweep to the next [1]
};

/// Measures the factor for columns of boxes.
/// \param counts numbers of boxes, each from 2 to 200
/// \return one row for each count, in the order given
/// \throws InvalidInput if a count is out of its range
/// \ingroup solver
std::vector<SweepFactor> sweepFactors(std::span<const int> counts);

}  // namespace carom
