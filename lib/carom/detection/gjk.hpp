#pragma once
// How far apart, or how deep in each other, are two convex solids? By support points alone.
//
// Method: GJK for the cores of the shapes (core_shape.hpp), EPA where the cores overlap or touch
// (expanding_polytope.hpp), then the radii.
// Why there is no tolerance to choose: both loops end where doubles can make no progress; the
// status and errorBound say how that went.
// Source: Gilbert, Johnson and Keerthi 1988; van den Bergen 2001 and 2003.
// Not handled: half-spaces and compounds (signed_distance.hpp takes any shapes).

#include <array>
#include <cstdint>

#include "carom/core/real.hpp"
#include "carom/detection/core_shape.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/separation.hpp"
#include "carom/detection/shapes.hpp"

namespace carom {

/// Where GJK ended for a pair, so that it can start there the next time. Plain data; a default one
/// means "unknown". The answer does not depend on it beyond rounding. \ingroup detection
struct SimplexCache {
  std::array<std::int32_t, 4> idA{};    ///< corners of A
  std::array<std::int32_t, 4> idB{};    ///< corners of B
  std::int32_t count = 0;               ///< how many of them; 0: unknown
  Vector3 direction = Vector3::Zero();  ///< last normal, used where shapes have no corners [world]
};

/// The signed distance of two convex solids.
/// \param a usable shape of A \param A its pose
/// \param b usable shape of B \param B its pose
/// \param cache if given, where to start; receives where it ended
/// \return separation, unit normal from A to B, a point on each, and a status. Distances are right
///   to a few ulp of the largest coordinate of the pair; so are depths of polyhedra
/// \ingroup detection
Separation gjk(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B,
               SimplexCache* cache = nullptr);

namespace detail {

/// gjk() of shapes whose cores are known already. \param a core of A \param A its pose
/// \param b core of B \param B its pose \param cache as for gjk() \return as gjk()
Separation gjkOfCores(const CoreShape& a, const Pose& A, const CoreShape& b, const Pose& B,
                      SimplexCache* cache);

}  // namespace detail
}  // namespace carom
