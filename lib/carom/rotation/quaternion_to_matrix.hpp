#pragma once
// The matrix of a quaternion.
//
// Nine sums and nine products per point are cheaper than two Hamilton products, so a body's
// quaternion is turned into a matrix once per step and the matrix turns its points. Written out
// from q v q*/|q|^2.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The rotation matrix R with R v = q v q* / |q|^2.
/// \param q rotation, body to world; any norm but zero
/// \return 3x3 rotation matrix, body to world [1]
/// \throws InvalidInput if q is zero or not finite
/// \ingroup rotation
Matrix3 quaternionToMatrix(const Quaternion& q);

}  // namespace carom
