#pragma once
// Which way does a body face when its angular velocity changes while it turns?
//
// Taking omega at one moment of the step is of first or second order, and a body that cones drifts
// away at a steady rate. Taking it at three moments, the Gauss points, and adding terms that say
// how the axis swings between them is of sixth order: the Magnus expansion, in the form of Blanes,
// Casas and Ros (BIT 40, 2000; Physics Reports 470, 2009, equation 253). The result is a rotation
// whatever dt is. Angular velocity is in the body here, as gyroscopes measure it, so it multiplies
// from the right.

#include <array>

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The three Gauss points in a step of length 1: 1/2 - sqrt(15)/10, 1/2, 1/2 + sqrt(15)/10.
/// \ingroup rotation
inline constexpr std::array<Real, 3> kGaussPoints = {0.11270166537925831148, 0.5,
                                                     0.88729833462074168852};

/// The orientation after turning at a varying angular velocity; error of order dt^6 over a fixed
/// time.
/// \param q orientation at the start, body to world; any norm but zero
/// \param rates omega at the times kGaussPoints * dt [rad/s, body]
/// \param dt duration [s]
/// \return orientation at the end, body to world, unit norm
/// \throws InvalidInput if q is zero, or anything is not finite
/// \ingroup rotation
Quaternion integrateBodyRate(const Quaternion& q, const std::array<Vector3, 3>& rates, Real dt);

}  // namespace carom
