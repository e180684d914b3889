#pragma once
// Is this matrix a rotation?
//
// Its columns must have length 1 and stand at right angles, and it must not mirror. Matrices that
// have been multiplied for a while are a little off; the limit lets them pass. Reading angles or a
// quaternion off a matrix that shears or mirrors would give numbers without meaning.

#include "carom/core/real.hpp"

namespace carom {

/// How far an entry of R^T R may be from the unit matrix. A million products of rotations drift by
/// 1e-10; a matrix that was typed with six digits passes, one that shears or scales visibly does
/// not.
/// \ingroup rotation
inline constexpr Real kRotationTolerance = 1e-5;

/// Lets only rotation matrices pass.
/// \param R the matrix [1]
/// \param name what it is called, for the message
/// \throws InvalidInput if R is not finite, not orthogonal within kRotationTolerance, or mirrors
/// \ingroup rotation
void requireRotation(const Matrix3& R, const char* name);

}  // namespace carom
