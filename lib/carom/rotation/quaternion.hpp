#pragma once
// A quaternion as the course writes it: w first.
//
// The engine computes with Eigen's quaternions (eigen_quaternion.hpp converts). This plain struct
// is what the functions of chapter 1 take and return: four named numbers, so that nobody has to
// remember that Eigen's constructor takes w first while its storage keeps w last.

#include "carom/core/real.hpp"

/// \defgroup rotation Rotation: chapter 1
/// Euler angles, axis and angle, matrices, quaternions, and how they turn into one another.

namespace carom {

/// q = w + x i + y j + z k with i² = j² = k² = ijk = -1. A rotation is a quaternion of norm 1; q
/// and -q are the same rotation. Default: the identity.
/// \source{4,5,6}
/// \ingroup rotation
struct Quaternion {
  Real w = 1;  ///< real part, cos(angle/2) for a rotation
  Real x = 0;  ///< factor of i
  Real y = 0;  ///< factor of j
  Real z = 0;  ///< factor of k
};

}  // namespace carom
