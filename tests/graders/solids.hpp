#pragma once
// Bodies as lists of corners, and ways to place them, for the graders of chapters 3 and 4.

#include <cmath>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/real.hpp"
#include "grading/random.hpp"

namespace carom::grading {

using Points = std::vector<Vector3>;

/// Corner n of the cube [-1, 1]^3: bit k of n says whether coordinate k is positive.
inline Vector3 cubeCorner(int n) {
  return {n & 1 ? 1.0 : -1.0, n & 2 ? 1.0 : -1.0, n & 4 ? 1.0 : -1.0};
}

/// A box along the axes, by two opposite corners [m].
inline Points boxBetween(const Vector3& low, const Vector3& high) {
  Points all;
  for (int n = 0; n < 8; ++n) {
    all.push_back(
        {n & 1 ? high.x() : low.x(), n & 2 ? high.y() : low.y(), n & 4 ? high.z() : low.z()});
  }
  return all;
}

/// A turn about a unit axis, by the rule of Rodrigues. \param angle [rad]
inline Matrix3 turn(const Vector3& axis, Real angle) {
  const Real s = std::sin(angle), c = std::cos(angle);
  Matrix3 R;
  for (int k = 0; k < 3; ++k) {
    const Vector3 e = Vector3::Unit(k);
    R.col(k) = c * e + s * cross(axis, e) + (1 - c) * axis.dot(e) * axis;
  }
  return R;
}

/// A turn about any axis. The angle is drawn first: arguments of a call have no order of their own,
/// and other compilers would ask other questions. \param low, high bounds of the angle [rad]
inline Matrix3 anyTurn(Random& random, Real low, Real high) {
  const Real angle = random.between(low, high);
  return turn(random.direction(), angle);
}

/// A vector of any direction. The direction is drawn first, for the same reason.
/// \param low, high bounds of its length
inline Vector3 anyVector(Random& random, Real low, Real high) {
  const Vector3 direction = random.direction();
  return random.between(low, high) * direction;
}

/// Points that have been turned about the origin and then moved.
inline Points moved(Points points, const Matrix3& R, const Vector3& by) {
  for (Vector3& p : points) p = R * p + by;
  return points;
}

}  // namespace carom::grading
