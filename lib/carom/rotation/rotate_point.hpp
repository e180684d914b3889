#pragma once
// Where does a rotation take a point?
//
// The sandwich q v q*: read the point as a quaternion without real part, multiply by q from the
// left and by its conjugate from the right. Both factors bring |q|, so the result is divided by
// |q|^2. The source normalises the left factor only, and its points come out |q| times too far
// away.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The point or vector v turned by q: q v q* / |q|^2.
/// \param q rotation, body to world; any norm but zero
/// \param v point relative to the centre of rotation, or free vector [any unit, body]
/// \return v turned [same unit, world], same length as v
/// \throws InvalidInput if q is zero or not finite
/// \source{9}
/// \erratum{3.13}
/// \ingroup rotation
Vector3 rotatePoint(const Quaternion& q, const Vector3& v);

}  // namespace carom
