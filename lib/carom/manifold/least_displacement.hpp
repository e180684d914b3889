#pragma once
// Which is the shortest way out of an overlap?
//
// Method: on every axis the bodies can be pushed apart forwards or backwards; the shorter of the
// two is the displacement of that axis, and the axis with the shortest displacement of all wins.
// The displacement of the pair lies along it.
// Two traps. The length that two shadows share is not the push: a small body deep inside a large
// one shares its own width only, and is still inside after being moved by that. And an axis that is
// not of length one measures in its own unit, so its depth must be divided by its length before
// depths are compared.
// Why the axes are an argument: they must hold the normals of both bodies and the cross products of
// their edges; with one of them missing the answer is some push that parts the bodies, not the
// least.
// Source: section 5.4; Eberly, Intersection of convex objects: the method of separating axes.
// Not handled: bodies that must be turned to come free.

#include <span>

#include "carom/core/real.hpp"

/// \defgroup manifold Manifold: chapter 4
/// Where two bodies touch: normal, points, area.

namespace carom {

/// The shortest push that parts two bodies.
/// \ingroup manifold
struct LeastDisplacement {
  Vector3 normal = Vector3::UnitZ();  ///< unit, from A to B: the way B has to go [1, world]
  Real separation = 0;                ///< minus the length of the way; positive: they are apart [m]
  int axis = -1;                      ///< number of the axis that it lies along
};

/// The axis on which two bodies overlap least, and by how much.
/// \param axes directions to try, any length but zero, at least one [any unit, world]
/// \param a corners of A, at least one [m, world]
/// \param b corners of B, at least one [m, world]
/// \return normal, separation and number of the best axis; of equal ones the first
/// \throws InvalidInput if there are no axes, no corners, or an axis is zero or not finite
/// \erratum{5.14}
/// \erratum{5.16}
/// \ingroup manifold
LeastDisplacement leastDisplacement(std::span<const Vector3> axes, std::span<const Vector3> a,
                                    std::span<const Vector3> b);

}  // namespace carom
