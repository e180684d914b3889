#pragma once
// Do two figures collide that are not convex?
//
// Method: cut each into convex parts (the source cuts Pacman into an upper and a lower half) and
// test every part of one against every part of the other. Two overlapping parts make the figures
// overlap; if there are none, two touching parts make them touch.
// Why: an axis can separate a body in Pacman's mouth from each half, but from the whole Pacman
// there may be none, so separating axes alone would report a bite that has not happened.
// Source: section 5.2 of the source; Eberly 2001.
// Not handled: how deep concave bodies are in each other. The deepest pair of parts is a push-out
// for that pair only.

#include <span>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/detection/verdict.hpp"

namespace carom {

/// How two planar figures stand to each other, each given as convex polygons that cover it.
/// \param partsA polygons of A, corners counter-clockwise [m, world]; at least one
/// \param partsB polygons of B, corners counter-clockwise [m, world]; at least one
/// \return separated, touching or overlapping
/// \throws InvalidInput if a figure has no parts, or a part has fewer than three corners
/// \ingroup detection
Verdict convexParts(std::span<const std::vector<Vector2>> partsA,
                    std::span<const std::vector<Vector2>> partsB);

}  // namespace carom
