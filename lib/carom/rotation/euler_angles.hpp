#pragma once
// Three angles for one orientation.
//
// Turn about the x axis, then about the y axis, then about the z axis, all three axes fixed in the
// world. The source calls these Euler angles; strictly they are Tait-Bryan angles, since Euler's
// own repeat an axis (z-x-z). Its letters (psi, phi, theta) for (roll, pitch, yaw) are the reverse
// of what most books write, so this library uses the words.

#include "carom/core/real.hpp"

namespace carom {

/// Roll, pitch and yaw: first roll about x, then pitch about y, then yaw about z, axes of the
/// world. At pitch = +-pi/2 (gimbal lock) only the sum or difference of roll and yaw has a meaning.
/// \erratum{3.7}
/// \ingroup rotation
struct EulerAngles {
  Real roll = 0;   ///< about the x axis, the source's psi [rad]
  Real pitch = 0;  ///< about the y axis, the source's phi [rad]
  Real yaw = 0;    ///< about the z axis, the source's theta [rad]
};

}  // namespace carom
