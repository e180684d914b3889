#pragma once
// Which boxes meet? Let a plane sweep through the scene.
//
// Method: the boxes are sorted by their low side on one axis, and met in that order. Those whose
// high side the plane has not passed yet are open; a new box is compared with the open ones alone,
// since all others ended before it begins.
// Why sorted by the low side: sorting by centres would let a large box that begins early come late.
// Source: Baraff, Dynamic Simulation of Non-Penetrating Rigid Bodies, 1992; Cohen, Lin, Manocha and
// Ponamgi, I-COLLIDE, 1995.
// Not handled: a scene that is crowded along this axis (a flat hall seen from the side keeps all
// boxes open); sorts that stay sorted from step to step, on the best axis: sorted_sweep.hpp.

#include <span>
#include <vector>

#include "carom/broadphase/index_pair.hpp"
#include "carom/detection/aabb.hpp"

namespace carom {

/// All pairs of closed boxes with a common point, by a sweep along x.
/// \param boxes each with low not above high, infinite sides allowed [m, world]
/// \return pairs of indices into boxes, sorted, each once
/// \throws InvalidInput if a box holds no point or a coordinate is not a number
/// \ingroup broadphase
std::vector<IndexPair> sweepAndPrune(std::span<const Aabb<3>> boxes);

}  // namespace carom
