#pragma once
// A quaternion whose square can be taken.
//
// As rotations, q and 1000 q are the same. But the squares of numbers beyond 1e154 overflow and
// those below 1e-162 vanish, so whoever divides by |q|^2 first scales by a power of two, which is
// exact. Zero and not-a-number are no rotation at all, and are refused here for every function that
// takes one.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The quaternion itself if its squares are safe, else times a power of two that makes them so.
/// \param q any quaternion that stands for a rotation
/// \param name what it is called, for the message
/// \return a positive multiple of q with a norm between 1e-60 and 1e61
/// \throws InvalidInput if q is zero or not finite
/// \ingroup rotation
Quaternion scaledQuaternion(const Quaternion& q, const char* name);

/// The square of the norm, w^2 + x^2 + y^2 + z^2.
/// \param q any quaternion, not far from ordinary size (see scaledQuaternion())
/// \return |q|^2
/// \ingroup rotation
inline Real squaredNorm(const Quaternion& q) {
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}

}  // namespace carom
