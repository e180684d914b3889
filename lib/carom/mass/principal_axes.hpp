#pragma once
// About which axes does a body turn without wobbling?
//
// Method: Jacobi's rotations (1846). Each turn of one coordinate plane makes one off-diagonal entry
// zero; a few sweeps over the three planes leave a diagonal tensor, and the product of the turns is
// the frame.
// Why Jacobi: it keeps every digit that the tensor has, even when two moments nearly agree, where
// the closed form with an arccosine (Smith 1961) loses half of them; and a tensor that is diagonal
// already is not turned.
// The frame is right-handed: a left-handed one is no rotation and would make no quaternion.
// Source: Golub and Van Loan, Matrix Computations, section 8.5.
// Not handled: where moments agree the axes are arbitrary; the ones nearest to the given axes are
// returned for a tensor that is diagonal, and any right-handed ones otherwise.

#include "carom/core/real.hpp"

namespace carom {

/// The principal moments and axes of an inertia tensor: I = axes · diag(moments) · axesᵀ.
/// \ingroup mass
struct PrincipalAxes {
  Vector3 moments = Vector3::Zero();  ///< principal moments, ascending [kg m^2]
  Matrix3 axes =
      Matrix3::Identity();  ///< columns: the unit axes, right-handed; maps principal to given axes
};

/// Turns an inertia tensor to its principal axes.
/// \param inertia symmetric 3x3 tensor; of the two halves the mean is used [kg m^2]
/// \return moments in ascending order and a right-handed frame (a proper rotation); the identity if
/// the tensor is diagonal with ascending entries
/// \throws InvalidInput if an entry is not finite or the tensor is not symmetric within rounding
/// \ingroup mass
PrincipalAxes principalAxes(const Matrix3& inertia);

}  // namespace carom
