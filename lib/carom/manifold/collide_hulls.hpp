#pragma once
// Where do two polyhedra touch?
//
// Method: the best axis (hull_axes.hpp); for a face the opposite face is clipped by its sides, for
// two edges the common perpendicular is the contact, unless faces beside both edges are within a
// few degrees of it: then these are clipped, and the separations measured along the perpendicular.
// The incident face is, of those that meet at the lowest vertex, the one that looks most against
// the normal. All choices are made from the geometry: by gap, by area, then by an order of the two
// bodies that does not depend on who is called A.
// Source: Catto, GDC 2007; Gregorius, GDC 2013.
// Not handled: faces of more than 128 corners are clipped by their first 128 sides.

#include "carom/detection/convex_hull.hpp"
#include "carom/detection/hull_view.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/manifold/manifold.hpp"
#include "carom/manifold/manifold_cache.hpp"

namespace carom {

/// The manifold of two polyhedra.
/// \param a first hull
/// \param A its pose
/// \param b second hull
/// \param B its pose
/// \param cache hints of this pair, or null; changes the time, never the result
/// \param margin surfaces up to this far apart still make points, with positive separation [m]
/// \return manifold; no points if the bodies are more than the margin apart
/// \ingroup manifold
Manifold collideHulls(const ConvexHull& a, const Pose& A, const ConvexHull& b, const Pose& B,
                      ManifoldCache* cache = nullptr, Real margin = 0);

/// The manifold of a box and a polyhedron.
/// \param a box
/// \param A its pose
/// \param b hull
/// \param B its pose
/// \param cache hints of this pair, or null; changes the time, never the result
/// \param margin surfaces up to this far apart still make points, with positive separation [m]
/// \return manifold; no points if the bodies are more than the margin apart
/// \ingroup manifold
Manifold collideBoxAndHull(const Box& a, const Pose& A, const ConvexHull& b, const Pose& B,
                           ManifoldCache* cache = nullptr, Real margin = 0);

/// The manifold of features that were the nearest ones before: a face and a face, or two edges.
/// Nobody looks whether others are nearer by now.
/// \param a first hull \param A its pose \param b second hull \param B its pose
/// \param features found for these two hulls by collideHulls() at other poses
/// \param margin points up to this gap are kept, zero or positive [m]
/// \return their manifold; empty if they do not face each other any more \ingroup manifold
Manifold collideHullsOn(const ConvexHull& a, const Pose& A, const ConvexHull& b, const Pose& B,
                        const ManifoldCache& features, Real margin);

}  // namespace carom
