#pragma once
// Which boxes meet? Look into the cells of a grid.
//
// Method: space is divided into cubes, and every box is entered into each cell that it reaches into.
// Those that meet are together in a cell. Two that share several cells are reported by one only:
// the cell with the low corner of what both have in common.
// Why a limit on cells: a continent among pebbles would fill millions of them. A box that reaches
// into more than 64 is big, is in no cell, and is compared with all others.
// Why the cells are numbered by doubles: a cell number fits whatever the coordinate; above 2^52
// neighbouring cells would get the same number, and there boxes count as big.
// Source: Ericson, Real-Time Collision Detection, 2005, chapter 7.
// Not handled: choosing the edge, and keeping the memory from step to step: pair_grid.hpp.

#include <span>
#include <vector>

#include "carom/broadphase/index_pair.hpp"
#include "carom/detection/aabb.hpp"

namespace carom {

/// All pairs of closed boxes with a common point, by a grid of cubes.
/// \param boxes each with low not above high, infinite sides allowed [m, world]
/// \param cell edge of the cubes [m]; best about the size of most boxes
/// \return pairs of indices into boxes, sorted, each once, whatever the edge
/// \throws InvalidInput if a box holds no point, a coordinate is not a number, or the edge is not
///   positive and finite
/// \ingroup broadphase
std::vector<IndexPair> gridPairs(std::span<const Aabb<3>> boxes, Real cell);

}  // namespace carom
