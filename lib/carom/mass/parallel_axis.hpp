#pragma once
// What is the inertia about a point that is not the centre of mass?
//
// Method: I' = I + m (|d|² E - d dᵀ), Steiner's theorem for all axes at once.
// Why the tensor: about a single axis the term is m times the squared distance between the two
// parallel axes, and that is what equation 19 says. Adding m |d|² to every diagonal entry is not
// the same: it forgets that moving along an axis changes nothing about that axis, and it loses the
// products of inertia. The theorem moves the axis of rotation. Where a force acts is another matter
// and enters through r x F alone.
// Source: equation 19.
// Not handled: going from one off-centre point to another; go through the centre.

#include "carom/core/real.hpp"

namespace carom {

/// The inertia tensor about a point, from the one about the centre of mass, along the same axes.
/// \param inertiaAboutCenter symmetric tensor about the centre of mass [kg m^2]
/// \param mass of the body, negative for a hole [kg]
/// \param offset from the centre of mass to the point, or back: the sign does not matter [m, same
/// axes]
/// \return tensor about the point [kg m^2, same axes]
/// \throws InvalidInput if an argument is not finite
/// \source{19}
/// \erratum{4.9,4.10} \ingroup mass
Matrix3 parallelAxis(const Matrix3& inertiaAboutCenter, Real mass, const Vector3& offset);

}  // namespace carom
