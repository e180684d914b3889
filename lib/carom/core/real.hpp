#pragma once
// Which number and which vectors does Carom compute with?
//
// One scalar type for the whole library: double. A float has 24 bits, so a body 1 km from the
// origin would know its place to 0.06 mm only; chapter 7 measures what that does. Templates on the
// scalar stay in the few places whose lesson is precision.

#include <Eigen/Core>

/// \defgroup core Core: numbers, vectors, checks
/// What every other layer stands on.

namespace carom {

/// The scalar of the library: IEEE 754 binary64.
/// \ingroup core
using Real = double;

/// A column of two numbers. Eigen leaves it uninitialised unless told otherwise. \ingroup core
using Vector2 = Eigen::Matrix<Real, 2, 1>;
/// A column of three numbers. Eigen leaves it uninitialised unless told otherwise. \ingroup core
using Vector3 = Eigen::Matrix<Real, 3, 1>;
/// A column of four numbers. Eigen leaves it uninitialised unless told otherwise. \ingroup core
using Vector4 = Eigen::Matrix<Real, 4, 1>;
/// A 2 x 2 matrix. \ingroup core
using Matrix2 = Eigen::Matrix<Real, 2, 2>;
/// A 3 x 3 matrix: a rotation, or an inertia tensor. \ingroup core
using Matrix3 = Eigen::Matrix<Real, 3, 3>;

}  // namespace carom
