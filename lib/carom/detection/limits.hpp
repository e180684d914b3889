#pragma once
// How small and how large may a body be?
//
// Method: lengths from 1e-40 m to 1e40 m, coordinates up to 1e40 m, checked where shapes and poses
// are made. Why these: the nearest point of a tetrahedron needs products of six lengths, and 1e240
// and 1e-240 are still doubles with all their digits. Beyond, squares overflow to infinity, and
// infinity minus infinity is no number. Nothing real is left out: an atomic nucleus measures 1e-15 m,
// what can be seen of the universe 1e27 m.

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/real.hpp"

namespace carom {

/// The shortest length that a shape may have [m]. \ingroup detection
inline constexpr Real kSmallestLength = 1e-40;
/// The longest length that a shape may have, and the largest coordinate [m]. \ingroup detection
inline constexpr Real kLargestLength = 1e40;

/// Lets only lengths pass that can be computed with.
/// \param value a length [m] \param name what it is called, for the message
/// \throws InvalidInput if it is not positive and finite, or outside of the limits
/// \ingroup detection
inline void requireLength(Real value, const char* name) {
  requirePositive(value, name);
  if (value < kSmallestLength || value > kLargestLength)
    reject(name, toText(value), "must be from 1e-40 to 1e40 m");
}

/// Lets only coordinates pass that can be computed with.
/// \param value a coordinate [m] \param name what it is called, for the message
/// \throws InvalidInput if it is not finite, or larger than the limit
/// \ingroup detection
inline void requireCoordinate(Real value, const char* name) {
  requireFinite(value, name);
  if (std::abs(value) > kLargestLength) reject(name, toText(value), "must be at most 1e40 m");
}

/// Lets only places pass that can be computed with.
/// \param value a point [m] \param name what it is called, for the message
/// \throws InvalidInput if a coordinate is not finite, or larger than the limit
/// \ingroup detection
inline void requireCoordinates(const Vector3& value, const char* name) {
  requireFinite(value, name);
  if (value.cwiseAbs().maxCoeff() > kLargestLength)
    reject(name, toText(value), "must have no coordinate above 1e40 m");
}

}  // namespace carom
