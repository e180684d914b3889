#pragma once
// How are many contacts solved that push on one another?
//
// Method: sequential impulses, which is Gauss and Seidel's method with limits. A sweep visits each
// block, takes the friction that its slip asks for within the cone, then along the normal what
// keeps each point from approaching; every impulse acts on the velocities at once, so that the next
// block sees it. The total of each row is limited, not what one visit adds. Sweeps go on until they
// change nothing any more, or the budget is used up.
// Why: each sweep costs as much as looking at the contacts once; beginning with the impulses of the
// last step (warm starting), a scene at rest needs one.
// Source: Moreau and Jean 1994 (contact dynamics); Catto, GDC 2006; Jourdan, Alart and Jean 1998
// for blocks of friction.
// Not handled: tall stacks and great ratios of mass, where a sweep gains little (chapter 9).

#include <cstdint>
#include <span>

#include "carom/solver/contact_patch.hpp"

namespace carom {

/// How long to sweep. \ingroup solver
struct SweepLimits {
  int least = 10;          ///< sweeps that are made if there is still change; positive
  int rowBudget = 0;       ///< more sweeps, until this many rows were visited in all
  Real tolerance = 1e-15;  ///< done when no row changes more than this share of the fastest [1]
  Real speed = 1;          ///< what is fast in this scene, at least [m/s]
};

/// What sweeping did. \ingroup solver
struct Sweeps {
  int sweeps = 0;         ///< over all blocks
  std::int64_t rows = 0;  ///< visited in all
  Real change = 0;        ///< largest change of speed by a row in the last sweep [m/s]
};

/// Sweeps over blocks until nothing changes or the limits are reached.
/// \param bodies their velocities are changed; the impulses that the blocks hold have been applied
/// \param blocks their impulses are changed
/// \param limits how long \return what was done
/// \ingroup solver
Sweeps solvePatches(std::span<MovingBody> bodies, std::span<ContactBlock> blocks,
                    const SweepLimits& limits);

}  // namespace carom
