#pragma once
// Do two balls collide, and how far apart are they?
//
// Method: the distance of the centres by Pythagoras, minus both radii: positive apart, zero
// touching, negative overlapping (figure 4 of the source). Circles are balls with z = 0.
// Why the verdict is asked separately: D = 0 after a rounded root is luck, so the sign is decided
// by the squares, exactly (gapSign()); and the squares of very large and very small numbers leave
// the range of doubles, so the length is taken by length().
// Source: equations 20 to 22.
// Not handled: balls whose centres are so far apart that their distance is beyond the doubles.

#include "carom/core/real.hpp"
#include "carom/detection/verdict.hpp"

namespace carom {

/// What there is between two balls. \ingroup detection
struct BallGap {
  Real separation = 0;                   ///< D: distance of the surfaces; negative: depth [m]
  Verdict verdict = Verdict::separated;  ///< its sign, decided exactly
};

/// The gap between two balls, or two circles with z = 0.
/// \param centerA centre of A [m, world]
/// \param radiusA radius of A, zero or positive [m]
/// \param centerB centre of B [m, world]
/// \param radiusB radius of B, zero or positive [m]
/// \return signed distance of the surfaces, error below 2 ulp of the sum of the radii or of the
///   distance of the centres, whichever is larger; and the exact verdict
/// \throws InvalidInput if a number is not finite or a radius is negative
/// \source{20,21,22}
/// \erratum{5.1}
/// \ingroup detection
BallGap ballBall(const Vector3& centerA, Real radiusA, const Vector3& centerB, Real radiusB);

}  // namespace carom
