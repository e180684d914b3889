#pragma once
// How far apart are two convex bodies of which only the corners are known?
//
// Method: the bodies are as far apart as the set of all differences a - b is from the origin. That
// set is convex, and its farthest point in a direction is a difference of farthest points
// (supportPoint()). GJK keeps a simplex of such differences, takes its point nearest to the origin,
// asks for the farthest point the other way, and throws away corners that no longer matter.
// Why it ends: each step comes strictly nearer, or there is nothing nearer and the answer is
// found. Comparing with a small number instead would never end for some touching bodies and end
// too early for tiny ones.
// Source: Gilbert, Johnson and Keerthi 1988; van den Bergen 2003.
// Not handled: how deep bodies overlap (penetration, gjk.hpp); bodies without corners.

#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// The distance of two convex bodies and where it is measured. \ingroup detection
struct PointDistance {
  Real distance = 0;                 ///< zero if they overlap or touch [m]
  Vector3 pointA = Vector3::Zero();  ///< nearest point of A; any common point if they overlap [m]
  Vector3 pointB = Vector3::Zero();  ///< nearest point of B; the same point if they overlap [m]
  int iterations = 0;                ///< support points asked for
};

/// The distance between the convex hulls of two sets of points.
/// \param a corners of A, at least one [m, world]
/// \param b corners of B, at least one [m, world]
/// \return distance, right to a few ulp of the coordinates (touching bodies: zero or as little as
///   that), and nearest points
/// \throws InvalidInput if a set is empty or a coordinate is not finite
/// \ingroup detection
PointDistance gjkDistance(std::span<const Vector3> a, std::span<const Vector3> b);

}  // namespace carom
