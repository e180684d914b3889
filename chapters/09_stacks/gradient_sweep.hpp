#pragma once
// What can sweeps learn from one another?
//
// Method: a sweep changes the impulses by as much as it finds missing, so it can be taken for a step
// downhill. As with conjugate gradients, some of the last direction is added to it: the share by
// which the squares of the changes have grown smaller (Fletcher and Reeves). If they have not, what
// was remembered is worth nothing, and it begins anew.
// Why that is allowed: a sweep that ends in the answer changes nothing, so the answer stays the
// answer; and no sum may become negative, neither in a sweep nor by the direction.
// Source: Silcowitz, Niebe and Erleben 2010, from Fletcher and Reeves 1964.
// Not handled: that it gets nearer with every sweep. Where contacts let go the error may rise.

#include <span>
#include <vector>

#include "carom/solver/contact_row.hpp"

namespace carom {

/// What is remembered from one sweep to the next. \ingroup solver
struct GradientMemory {
  std::vector<Real> direction;  ///< of the last change, by row [N s]
  Real square = 0;              ///< of what the last sweep alone has changed [N^2 s^2]
};

/// One sweep, and a part of the last direction.
/// \param bodies their velocities are changed \param rows their impulses are changed; they have
/// been applied to the bodies \param memory of the sweeps so far; empty at the start
/// \ingroup solver
void gradientSweep(std::span<MovingBody> bodies, std::span<ContactRow> rows,
                   GradientMemory& memory);

}  // namespace carom
