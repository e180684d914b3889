#pragma once
// The cross product, without Eigen's Geometry module.
//
// Chapter 1 writes rotations itself, so its files must not see Eigen's quaternions and angle-axes,
// which come in the same header as Eigen's cross product.

#include "carom/core/real.hpp"

namespace carom {

/// The cross product a x b of two vectors in one frame: perpendicular to both, length |a||b| sin of
/// the angle between them, right-handed.
/// \param a first factor [any unit]
/// \param b second factor [any unit]
/// \return a x b [product of the units]
/// \ingroup core
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y() * b.z() - a.z() * b.y(),  //
          a.z() * b.x() - a.x() * b.z(),  //
          a.x() * b.y() - a.y() * b.x()};
}

}  // namespace carom
