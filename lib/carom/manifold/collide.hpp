#pragma once
// Where do two bodies touch? One door for all pairs.
//
// Method: balls by nearest points, half-spaces by heights, boxes and hulls by separating axes and
// clipping, everything else by GJK and the features along its normal. A compound has one manifold
// for each pair of its parts that touch.
// The result depends on shapes and poses alone: not on a cache, not on the last step; and swapping
// A and B turns the normal, swaps the names, and changes nothing else.
// Why a switch over the kinds and not a table of functions: a new shape makes it fail to compile.
// Not handled: half-space against half-space, which has no points.

#include <span>
#include <vector>

#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/manifold/manifold.hpp"
#include "carom/manifold/manifold_cache.hpp"

namespace carom {

/// The manifold of two convex bodies.
/// \param a usable shape of A
/// \param A its pose
/// \param b usable shape of B
/// \param B its pose
/// \param cache hints of this pair, or null; changes the time, never the result
/// \param margin surfaces up to this far apart still make points, with positive separation; zero or
///   more [m]
/// \return manifold; no points if the bodies are more than the margin apart
/// \ingroup manifold
Manifold collide(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B,
                 ManifoldCache* cache = nullptr, Real margin = 0);

/// The manifold of a part of A with a part of B.
/// \ingroup manifold
struct PartManifold {
  int partA = 0;      ///< number of A's part; 0 if A is no compound
  int partB = 0;      ///< number of B's part; 0 if B is no compound
  Manifold manifold;  ///< of these two parts; at least one point
};

/// The manifolds of two bodies of any shape.
/// \param a usable shape of A
/// \param A its pose
/// \param b usable shape of B
/// \param B its pose
/// \param manifolds receives one per pair of parts that touch, ordered by part of A, then of B;
///   what was in it is lost
/// \param caches hints, one per pair of parts, part of A first; or empty
/// \param margin surfaces up to this far apart still make points; zero or more [m]
/// \throws InvalidInput if both are half-spaces, the margin is negative, or there are caches but
///   not one per pair of parts
/// \ingroup manifold
void collide(const Shape& a, const Pose& A, const Shape& b, const Pose& B,
             std::vector<PartManifold>& manifolds, std::span<ManifoldCache> caches = {},
             Real margin = 0);

/// How many pairs of parts two bodies have: the number of caches that collide() wants.
/// \param a shape of A \param b shape of B
/// \return parts of A times parts of B
/// \ingroup manifold
int pairsOfParts(const Shape& a, const Shape& b);

}  // namespace carom
