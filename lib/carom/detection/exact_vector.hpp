#pragma once
// Vectors without rounding: differences, dot and cross products of exact numbers.
//
// What the exact judges of the separating-axis tests compute with (exact_number.hpp). A placed
// corner R x + p is a polynomial of doubles like everything else here, so even a turned body has
// exact corners; only its length-one normals do not exist.
// Not handled: division and square roots.

#include <array>

#include "carom/core/real.hpp"
#include "carom/detection/exact_number.hpp"
#include "carom/detection/pose.hpp"

namespace carom {

/// Three exact coordinates. \ingroup detection
using ExactVector = std::array<ExactNumber, 3>;

/// A vector of doubles, exactly. \param v any finite vector \return the same \ingroup detection
inline ExactVector exact(const Vector3& v) {
  return {v.x(), v.y(), v.z()};
}

/// Difference. \param a first \param b second \return a - b \ingroup detection
inline ExactVector operator-(const ExactVector& a, const ExactVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Dot product. \param a first \param b second \return a . b \ingroup detection
inline ExactNumber dot(const ExactVector& a, const ExactVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Cross product. \param a first \param b second \return a x b \ingroup detection
inline ExactVector cross(const ExactVector& a, const ExactVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A point of a body in world coordinates, exactly: R x + p of the doubles in the pose.
/// \param pose of the body \param x point [m, body] \return point [m, world] \ingroup detection
inline ExactVector exactPoint(const Pose& pose, const Vector3& x) {
  ExactVector placed;
  for (int row = 0; row < 3; ++row) {
    placed[row] = ExactNumber(pose.p_WB[row]);
    for (int col = 0; col < 3; ++col) {
      placed[row] += ExactNumber(pose.R_WB(row, col)) * ExactNumber(x[col]);
    }
  }
  return placed;
}

/// A rounded copy. \param v exact \return each coordinate as a double \ingroup detection
inline Vector3 rounded(const ExactVector& v) {
  return {v[0].value(), v[1].value(), v[2].value()};
}

}  // namespace carom
