#pragma once
// The bridge between the course's quaternion and the engine's.
//
// The engine computes with Eigen's quaternions. This is the only header that includes Eigen's
// Geometry module, so that the files of chapter 1 stand on their own feet. Mind the order: Eigen's
// constructor takes (w, x, y, z), its coeffs() are stored (x, y, z, w).

#include <Eigen/Geometry>

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The same quaternion in Eigen's type. \param q any quaternion \return the same four numbers
/// \ingroup rotation
inline Eigen::Quaterniond toEigen(const Quaternion& q) {
  return {q.w, q.x, q.y, q.z};
}

/// The same quaternion in the course's type. \param q any quaternion \return the same four numbers
/// \ingroup rotation
inline Quaternion fromEigen(const Eigen::Quaterniond& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace carom
