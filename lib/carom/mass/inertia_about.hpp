#pragma once
// What does an inertia tensor say about one axis, and about other axes?
//
// Method: the moment about a unit axis n is n · I n. In another frame the tensor's components are R
// I Rᵀ.
// Why: a tensor is not just a matrix of numbers. It is a property of the body, and the matrix is
// how it looks along given axes. The inverse tensor turns a torque into an angular acceleration,
// never into a moment.
// Source: section 4.2.1 of the source text, corrected.
// Not handled: axes that miss the point the tensor is about (parallelAxis() moves it first).

#include "carom/core/real.hpp"

namespace carom {

/// The moment of inertia about one axis through the point that the tensor is about: n · I n.
/// \param inertia symmetric tensor [kg m^2]
/// \param axis direction of the axis, any length but zero [any unit, same axes]
/// \return moment of inertia [kg m^2]
/// \throws InvalidInput if axis is zero or not finite
/// \erratum{4.8,4.11}
/// \ingroup mass
Real momentAboutAxis(const Matrix3& inertia, const Vector3& axis);

/// The same tensor along other axes: R I Rᵀ.
/// \param inertia symmetric tensor [kg m^2, axes of B]
/// \param R_WB rotation that maps components along B to components along W
/// \return the tensor, exactly symmetric [kg m^2, axes of W]
/// \erratum{4.7}
/// \ingroup mass
Matrix3 rotateInertia(const Matrix3& inertia, const Matrix3& R_WB);

}  // namespace carom
