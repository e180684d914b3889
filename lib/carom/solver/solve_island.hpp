#pragma once
// How much work does an island need?
//
// Method: look first. Where the impulses to start with are the solution but for rounding, nothing
// is done, and nothing changes. A single contact that sticks is solved at once (hold_block.hpp).
// Else a few sweeps, which is all that most islands want, and as many more as gain where bodies are
// in motion. Only where these gain little, because a load passes through many bodies or from heavy
// to light ones, the island is solved directly (island_newton.hpp), if it is small enough; what that
// cannot solve is swept over as long as the limits allow.
// Not handled: islands of thousands of bodies in motion, whose factors would cost more than they
// gain.

#include "carom/solver/island_newton.hpp"
#include "carom/solver/solve_patches.hpp"

namespace carom {

/// How an island is solved. \ingroup solver
struct IslandLimits {
  SweepLimits sweeps;  ///< for sweeps alone, and where the direct method fails
  bool direct = true;  ///< look first, and solve directly where sweeps gain little
  bool newton = true;  ///< false: only look
  bool moves = false;  ///< nothing stands: bodies meet in an impact, or roll and fall
  /// Products of blocks of six by six that a direct solution may cost.
  std::int64_t directWork = 20'000;
};

/// What solving an island took. \ingroup solver
struct IslandSolution {
  std::int64_t rows = 0;        ///< visited by sweeps
  int factorisations = 0;       ///< of the direct method
  std::int64_t directWork = 0;  ///< what that cost, about, in visits of a row
  bool direct = false;          ///< solved directly
  bool looked = false;   ///< what the bodies carry is known, see IslandNewton::dropRounding()
  bool settled = false;  ///< what is left is small: the solution
};

/// Solves an island. \param newton its memory \param bodies their velocities are changed; the
/// impulses that the blocks hold have been applied \param blocks their impulses are changed
/// \param limits how long \return what was done
/// \ingroup solver
IslandSolution solveIsland(IslandNewton& newton, std::span<MovingBody> bodies,
                           std::span<ContactBlock> blocks, const IslandLimits& limits);

}  // namespace carom
