#pragma once
// Where do two boxes touch?
//
// Method: the best of fifteen axes (box_axes.hpp). If it is the normal of a face, or within a few
// degrees of one on both boxes, the opposite face is clipped by the rectangle of the reference
// face; otherwise two edges cross, and their common perpendicular is the contact.
// The reference face is chosen by the geometry alone: by gap, then by area, then by an order of the
// two boxes that does not depend on who is called A. What was found in the last step has no say.
// Why clip also for a crossing of edges that is nearly flat: a box that rests on another and tilts
// by a billionth touches first where two edges cross. The normal of that crossing is the exact
// least displacement, but held at that point alone the box would rock.
// Source: Gottschalk, Lin and Manocha 1996; Catto, GDC 2007; Gregorius, GDC 2013.
// Not handled: contact at both ends of two nearly parallel edges that stand on each other.

#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/manifold/manifold.hpp"
#include "carom/manifold/manifold_cache.hpp"

namespace carom {

/// The manifold of two boxes.
/// \param a first box
/// \param A its pose
/// \param b second box
/// \param B its pose
/// \param cache hints of this pair, or null; changes the time, never the result
/// \param margin surfaces up to this far apart still make points, with positive separation [m]
/// \return manifold; no points if the boxes are more than the margin apart
/// \ingroup manifold
Manifold collideBoxes(const Box& a, const Pose& A, const Box& b, const Pose& B,
                      ManifoldCache* cache = nullptr, Real margin = 0);

}  // namespace carom
