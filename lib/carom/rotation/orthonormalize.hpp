#pragma once
// How does a matrix that has drifted become a rotation again?
//
// Take the rotation nearest to it, the orthogonal factor of its polar decomposition: iterate X <-
// (X + X^-T) / 2, which converges quadratically (Higham, SIAM J. Sci. Stat. Comput. 7, 1986). X^-T
// needs no general inverse: its columns are cross products of columns of X over the determinant.
// Gram-Schmidt is shorter but keeps the first column as it is, error and all. For a quaternion one
// division does the same job, one reason why orientations are stored as quaternions.

#include "carom/core/real.hpp"

namespace carom {

/// The rotation matrix nearest to M, entries right to about 4e-16.
/// \param M matrix with positive determinant that nearly is a rotation, or any multiple of one
/// \return the rotation matrix R that makes the sum of squares of R - M smallest [1]
/// \throws InvalidInput if M is not finite, mirrors, or has its columns (nearly) in one plane
/// \ingroup rotation
Matrix3 orthonormalize(const Matrix3& M);

}  // namespace carom
