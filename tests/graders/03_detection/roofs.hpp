#pragma once
// Two cubes of half extent 1 that lie like roofs, one ridge across the other: no face knows of it
// when they part, at a height of 2 sqrt(2) m.

#include <cmath>

#include "carom/detection/pose.hpp"
#include "graders/solids.hpp"

namespace carom::grading {

inline Pose at(const Vector3& place, const Matrix3& R = Matrix3::Identity()) {
  return {R, place};
}

inline const Real kEighth = std::acos(-1.0) / 4;  // an eighth of a turn [rad]

/// The lower cube, its ridge along y.
inline const Pose roof = at({0, 0, 0}, turn(Vector3::UnitY(), kEighth));

/// The upper cube, its ridge along x. \param height of its middle [m]
inline Pose roofAbove(Real height) {
  return at({0, 0, height}, turn(Vector3::UnitX(), kEighth));
}

}  // namespace carom::grading
