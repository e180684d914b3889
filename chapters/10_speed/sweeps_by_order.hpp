#pragma once
// What does it cost to solve contacts colour by colour, and not in the order of the building?
//
// Method: a pyramid of boxes falls onto the ground at 1 m/s. Its rows are swept from below upwards,
// and, in another run, colour by colour, until no box moves up or down faster than 1 mm/s. The
// sweeps are counted.
// Why sweeps and not time: a sweep is the same work in both orders, and counts are the same on every
// machine.
// Not handled: what lanes and threads save in each sweep, which is the other side of the bargain.

#include <span>
#include <vector>

namespace carom {

/// What was counted of a pyramid. \ingroup solver
struct SweepsByOrder {
  int height = 0;   ///< layers of boxes
  int upwards = 0;  ///< sweeps from below upwards
  int byColor = 0;  ///< sweeps colour by colour
};

/// Counts sweeps of pyramids.
/// \param heights layers of each, each from 1 to 30
/// \return one row for each height, in the order given
/// \throws InvalidInput if a height is out of its range
/// \ingroup solver
std::vector<SweepsByOrder> sweepsByOrder(std::span<const int> heights);

}  // namespace carom
