#pragma once
// In which order are impacts resolved that several threads have found?
//
// Method: each thread has a list of its own. The lists are put together and sorted by time, and
// impacts of one time by the numbers of their bodies. An impact of bodies 3 and 7 may have been
// found from either side, by two threads: it is named 3-7, and kept once.
// Why not by time alone: impacts of one time are common (a row of balls, a wall of boxes), and would
// stand in the order in which the threads were done.
// Not handled: times that differ by rounding; whoever finds an impact from both sides has to
// compute its time in one way.

#include <cstdint>
#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// An impact that a thread has found. \ingroup solver
struct FoundImpact {
  Real time = 0;           ///< when [s]
  std::int32_t bodyA = 0;  ///< number of one body
  std::int32_t bodyB = 0;  ///< of the other
};

/// Puts lists together, the same whatever stood in which list.
/// \param lists one per thread, each in any order
/// \return all impacts once, the smaller number first in each, by time, then by the numbers
/// \throws InvalidInput if a time is not finite, or a body meets itself
/// \ingroup solver
std::vector<FoundImpact> mergeFound(std::span<const std::vector<FoundImpact>> lists);

}  // namespace carom
