#pragma once
// How does a quaternion that has drifted become a rotation again?
//
// Divide by its norm, as for any vector of four numbers. Rounding moves the norm of a product of
// unit quaternions by up to an ulp; over a million steps that is visible, so the norm is put right
// where orientations are integrated, and nowhere else.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The quaternion of norm 1 in the direction of q; its norm is within 2 ulp of 1. Doing it
/// twice is the same as doing it once.
/// \param q any quaternion but zero
/// \return q / |q|
/// \throws InvalidInput if q is zero or not finite
/// \source{10}
/// \ingroup rotation
Quaternion renormalize(const Quaternion& q);

}  // namespace carom
