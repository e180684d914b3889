#pragma once
// Which boxes can the broad phase work with?
//
// Those whose low corner is not above the high one; infinite sides are welcome (the box of a
// half-space has them), numbers that are none are not: a comparison with NaN is false whatever it
// asks, and a body would silently meet nothing, or everything.

#include "carom/detection/aabb.hpp"

namespace carom {

/// Lets only boxes pass that hold a point.
/// \tparam Dim 2 or 3
/// \param box low not above high, no NaN; sides may be infinite [m]
/// \throws InvalidInput otherwise, with the corners
/// \ingroup broadphase
template <int Dim>
void requireBox(const Aabb<Dim>& box);

/// \cond
extern template void requireBox(const Aabb<2>& box);
extern template void requireBox(const Aabb<3>& box);
/// \endcond

/// Lets only usable numbers of items pass.
/// \param item what the caller calls one of its boxes
/// \throws InvalidInput if it is negative or above 2^30
/// \ingroup broadphase
void requireItem(std::int32_t item);

}  // namespace carom
