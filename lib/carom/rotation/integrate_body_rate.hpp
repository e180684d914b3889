#pragma once
// Which way does a body face when its angular velocity changes while it turns?
//
// Taking omega at one moment of the step is of first or second order, and a body that cones drifts
// away at a steady rate. Taking it at two moments, the Gauss points (1/2 -+ sqrt(3)/6) dt, and
// adding the term that says how the axis swings between them is of fourth order: the Magnus
// expansion (Iserles and Norsett 1999; Blanes, Casas, Oteo and Ros, Physics Reports 470, 2009). The
// result is a rotation whatever dt is. Angular velocity is in the body here, as gyroscopes measure
// it, so it multiplies from the right.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The place of the first Gauss point in a step of length 1; the second lies at 1 minus it.
/// \ingroup rotation
inline constexpr Real kFirstGaussPoint = 0.21132486540518711775;

/// The orientation after turning at a varying angular velocity; error of order dt^4 over a fixed
/// time.
/// \param q orientation at the start, body to world; any norm but zero
/// \param earlyRate omega at kFirstGaussPoint * dt [rad/s, body]
/// \param lateRate omega at (1 - kFirstGaussPoint) * dt [rad/s, body]
/// \param dt duration [s]
/// \return orientation at the end, body to world, unit norm
/// \throws InvalidInput if q is zero, or anything is not finite
/// \ingroup rotation
Quaternion integrateBodyRate(const Quaternion& q, const Vector3& earlyRate, const Vector3& lateRate,
                             Real dt);

}  // namespace carom
