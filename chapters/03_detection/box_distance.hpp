#pragma once
// How far apart are two boxes along the axes?
//
// Method: on each axis the boxes are some way apart or they overlap. Only the axes on which they
// are apart add to the distance, by Pythagoras: where they overlap one need not go at all.
// Why: a scene asks for pairs that are nearer than a margin, not only for those that overlap.
// Source: Arvo, Graphics Gems 1990, for a box and a ball.
// Not handled: how deep boxes overlap; boxes that hold no point.

#include "carom/core/real.hpp"
#include "carom/detection/aabb.hpp"

namespace carom {

/// The distance of two closed boxes along the axes.
/// \param a one box, low not above high [m, world]
/// \param b another box, low not above high [m, world]
/// \return distance of their nearest points; zero if they touch or overlap [m]
/// \throws InvalidInput if a coordinate is not a number
/// \ingroup detection
Real boxDistance(const Aabb<3>& a, const Aabb<3>& b);

}  // namespace carom
