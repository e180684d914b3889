#pragma once
// Which matrix turns about a given axis by a given angle?
//
// Rodrigues' formula: a point v becomes v cos w + (a x v) sin w + a (a.v)(1 - cos w). The part
// along the axis stays, the part across it turns in its plane. The source says that an axis and an
// angle cannot rotate points directly; this formula does. 1 - cos w is computed as 2 sin^2(w/2),
// which keeps its digits when w is small.

#include "carom/core/real.hpp"

namespace carom {

/// The matrix that turns by an angle about an axis, counter-clockwise seen from the tip of the
/// axis.
/// \param axis direction of the axis [any unit, world]; its length does not matter
/// \param angle [rad], any size
/// \return 3x3 rotation matrix [1]
/// \throws InvalidInput if the axis is zero or not finite, or the angle is not finite
/// \source{3}
/// \erratum{3.9}
/// \ingroup rotation
Matrix3 axisAngleToMatrix(const Vector3& axis, Real angle);

}  // namespace carom
