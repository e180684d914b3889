#pragma once
// How is a compensated sum as fast as a plain one?
//
// A plain loop waits for each addition before it can begin the next; the processor, which could do
// eight meanwhile, idles. Eight sums side by side, lane k taking every eighth term, keep it busy:
// the work of compensating each of them takes the time that the plain loop waited. Lanes are a
// fixed part of the method and not a matter of the machine: the same terms give the same bits on
// every processor. Sums and losses of the lanes are then put together without loss.

#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// The sum of numbers, with the error of compensatedSum(): 1 ulp of the result plus n^2 2^-106
/// times the sum of the absolute values of the n terms.
/// \param terms any finite numbers [any unit]; none at all add up to 0
/// \return their sum [the same unit]
/// \ingroup precision
Real compensatedSumInLanes(std::span<const Real> terms);

}  // namespace carom
