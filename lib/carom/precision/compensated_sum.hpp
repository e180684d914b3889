#pragma once
// What is the sum of many numbers, to the last digit?
//
// Each addition loses the low digits of the smaller number. Their loss is computed exactly and
// collected beside the sum, and added once, at the end: Neumaier (ZAMM 54, 1974), who improved
// Kahan's method (Communications of the ACM 8, 1965). NeumaierSum is the same sum for terms that
// come one by one, lane_sum.hpp the same at the speed of a plain loop. What it does not handle:
// sums whose terms cancel to less than 1e-32 of their size (exact_sum.hpp), and infinite terms.

#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// The sum of numbers, with an error of at most 1 ulp of the result plus n^2 2^-106 times the sum
/// of the absolute values of the n terms.
/// \param terms any finite numbers [any unit]; none at all add up to 0
/// \return their sum [the same unit]
/// \ingroup precision
Real compensatedSum(std::span<const Real> terms);

}  // namespace carom
