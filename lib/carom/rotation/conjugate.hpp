#pragma once
// The rotation backwards.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The conjugate q* = w - x i - y j - z k: for a unit quaternion the inverse rotation.
/// \param q any quaternion
/// \return q with the signs of x, y and z changed
/// \ingroup rotation
inline Quaternion conjugate(const Quaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

}  // namespace carom
