#pragma once
// The manifold of two polyhedra, put together from the functions of the chapter.
//
// Method: list the axes, take the least displacement, clip the faces or cross the edges, name the
// points, keep four. Every step is a function that an exercise replaces; a program that is built
// with a student's functions takes this way, so a wrong answer shows.
// Why beside the fast one: this is what the page explains, and what collideHulls() is compared
// with.
// Not handled: speed; (FA + FB + EA EB)(VA + VB) products.

#include "carom/core/real.hpp"
#include "carom/detection/convex_hull.hpp"
#include "carom/detection/pose.hpp"
#include "carom/manifold/manifold.hpp"

namespace carom {

/// The manifold of two polyhedra, made of the plain functions of chapter 4.
/// \param a first hull
/// \param A its pose
/// \param b second hull
/// \param B its pose
/// \param margin surfaces up to this far apart still make points, with positive separation [m]
/// \return manifold; no points if the bodies are more than the margin apart
/// \ingroup manifold
Manifold plainManifold(const ConvexHull& a, const Pose& A, const ConvexHull& b, const Pose& B,
                       Real margin = 0);

}  // namespace carom
