#pragma once
// Which four of many contact points hold a body as all of them would?
//
// Method: the points are the corners of a convex polygon, in order. Of all ways to choose four,
// take the one that spans the largest area: for each diagonal the farthest corner on either side.
// If the deepest corner is not among them, it takes the place of a neighbour, the one that costs
// less area.
// Why four: a solver's work grows with the points, and a rigid body on a plane cannot tell four
// points at the ends from forty between them, as long as its weight stays above the same area.
// Why not the four deepest: they often stand side by side.
// Ties go to the points that come first, so that equal input gives equal output.
// Source: own; the aim is that of Bullet's and Jolt's manifold reductions.
// Not handled: points in any other order.

#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// Chooses at most four corners of a flat convex polygon that keep most of its area.
/// \param corners in order around the polygon [m, world]
/// \param separations one per corner, negative inside [m]
/// \return numbers of the chosen corners, ascending: all if there are four or fewer
/// \throws InvalidInput if there are not as many separations as corners
/// \ingroup manifold
std::vector<int> reduceContacts(std::span<const Vector3> corners,
                                std::span<const Real> separations);

/// Depths that differ by less than this part of the polygon's size are taken as equal: the deepest
/// corner of a body that lies flat is chosen by rounding, and must not decide which corners stay.
/// \ingroup manifold
inline constexpr Real kDepthTie = 1e-9;

}  // namespace carom
