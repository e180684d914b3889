#pragma once
// Do two balls touch, without any doubt?
//
// Method: the sign of |b - a|^2 - (r + s)^2. No root is needed for a sign. The squares are first
// compared in double; only where rounding could have turned the comparison are they summed without
// error (precision/exact_sum.hpp).
// Why: D = 0 of a rounded root is luck. Balls of radius sqrt(3)/2 rounded, one at the origin and
// one at (1, 1, 1), are 1e-16 m apart, and equation (22) says 0.
// Not handled: coordinates more than 2^500 times smaller than the largest number count as zero.

#include "carom/core/real.hpp"

namespace carom {

/// The exact sign of the gap between two balls.
/// \param centerA centre of A [m, world]
/// \param radiusA radius of A, not negative [m]
/// \param centerB centre of B [m, world]
/// \param radiusB radius of B, not negative [m]
/// \return 1 if they are apart, 0 if they touch, -1 if they overlap; all numbers must be finite
/// \ingroup detection
int gapSign(const Vector3& centerA, Real radiusA, const Vector3& centerB, Real radiusB);

/// The gap between two balls to full relative precision, also where it is tiny: the exact
/// difference of the squares over the sum of the roots, because D = (d^2 - R^2) / (d + R).
/// \param centerA centre of A [m, world]
/// \param radiusA radius of A, not negative [m]
/// \param centerB centre of B [m, world]
/// \param radiusB radius of B, not negative [m]
/// \return signed gap [m], right to a few ulp of itself; all numbers must be finite
/// \ingroup detection
Real preciseGap(const Vector3& centerA, Real radiusA, const Vector3& centerB, Real radiusB);

}  // namespace carom
