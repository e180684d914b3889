#pragma once
// How are four rows solved at once?
//
// Method: four rows of one colour are a block, and of each number the block has four side by side.
// The speeds of four bodies are gathered into lanes, solveRow() is done with lanes for numbers, and
// the speeds go back to where they came from. Each lane decides for itself whether its contact
// pushes: both outcomes are there, and one is selected.
// Why the same order of sums as in solveRow(): then it is the same to the last bit, and nobody has
// to wonder whether a lane more has changed a scene.
// Source: as in the library's kernel (soft_rows_kernel.hpp); wide contacts: Catto 2025 (Box3D).
// Not handled: friction, soft contacts; other widths than four.

#include <array>
#include <cstdint>
#include <span>

#include "lane_values.hpp"
#include "plain_row.hpp"

namespace carom {

/// Four rows of one colour: no two of them move the same body. \ingroup solver
struct RowBlock {
  /// A's, or kNobody; in a lane without a row both bodies are nobody.
  std::array<std::int32_t, kBlockLanes> bodyA = {kNobody, kNobody, kNobody, kNobody};
  std::array<std::int32_t, kBlockLanes> bodyB = bodyA;  ///< B's, or kNobody
  std::array<LaneValues, 6> alongA;   ///< of A's speeds in the speed of parting [1, m]
  std::array<LaneValues, 6> alongB;   ///< of B's [1, m]
  std::array<LaneValues, 6> changeA;  ///< what a unit of impulse adds to A's [1/kg, 1/(kg m)]
  std::array<LaneValues, 6> changeB;  ///< to B's [1/kg, 1/(kg m)]
  LaneValues mass;                    ///< effective [kg]
  LaneValues target;                  ///< at least this fast they have to part [m/s]
  LaneValues impulse;                 ///< the sum so far [N s]
};

/// Visits blocks of rows, one block after the other, each as solveRow() would do its rows.
/// \param blocks their impulses change; lanes without a row may hold anything
/// \param speeds of all bodies; only those that rows name change
/// \throws InvalidInput if a row names a body that does not exist
/// \ingroup solver
void lanesSolver(std::span<RowBlock> blocks, std::span<BodySpeeds> speeds);

}  // namespace carom
