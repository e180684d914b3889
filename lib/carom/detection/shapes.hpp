#pragma once
// Which solids does the library know?
//
// Method: a handful of plain structs and one std::variant of them. Each solid lives in its own
// frame; a Pose places it. Round solids are kept round: a ball is a point with a radius, a capsule
// a line with a radius, so their distances come from the point and the line, exactly.
// Why a variant: the list is short and closed, a switch over it is visible to the compiler, and a
// new shape makes every function that forgot it fail to compile.
// Not handled: concave solids in one piece. They are compounds of convex parts (the source's
// Pacman). Everything that takes a Shape trusts it; requireUsable() and the make... functions are
// the doors.

#include <span>
#include <variant>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/detection/convex_hull.hpp"
#include "carom/detection/pose.hpp"

namespace carom {

/// All points within a radius of the body's origin. \ingroup detection
struct Ball {
  Real radius = 1;  ///< positive [m]
};

/// A box about the body's origin with its faces along the axes. \ingroup detection
struct Box {
  Vector3 halfExtents = Vector3::Ones();  ///< half lengths along x, y, z, positive [m, body]
};

/// All points within a radius of a piece of the z axis. \ingroup detection
struct Capsule {
  Real radius = 1;      ///< positive [m]
  Real halfLength = 1;  ///< the piece reaches from z = -halfLength to halfLength; positive [m]
};

/// A circular cylinder about the z axis. \ingroup detection
struct Cylinder {
  Real radius = 1;      ///< positive [m]
  Real halfHeight = 1;  ///< from z = -halfHeight to halfHeight; positive [m]
};

/// All points x with normal . x <= offset: a floor, a wall. Bodies lie outside of it.
/// \ingroup detection
struct HalfSpace {
  Vector3 normal = Vector3::UnitZ();  ///< unit, out of the solid [1, body]
  Real offset = 0;                    ///< distance of its plane from the origin, signed [m]
};

/// A convex solid without an end in itself: what a compound is made of. \ingroup detection
using ConvexShape = std::variant<Ball, Box, Capsule, Cylinder, ConvexHull>;

/// One convex part of a compound. \ingroup detection
struct CompoundPart {
  ConvexShape shape;  ///< the part in its own frame
  Pose pose;          ///< body from part: R_WB and p_WB take the part's frame to the body's
};

/// A solid made of convex parts that are rigidly joined; they may overlap. \ingroup detection
struct Compound {
  std::vector<CompoundPart> parts;  ///< at least one
};

/// Any solid. \ingroup detection
using Shape = std::variant<Ball, Box, Capsule, Cylinder, ConvexHull, HalfSpace, Compound>;

/// A ball. \param radius positive [m] \return the ball
/// \throws InvalidInput if the radius is not positive and finite \ingroup detection
Ball makeBall(Real radius);

/// A box. \param halfExtents half lengths along x, y, z, positive [m, body] \return the box
/// \throws InvalidInput if one is not positive and finite \ingroup detection
Box makeBox(const Vector3& halfExtents);

/// A capsule along z. \param radius positive [m] \param halfLength of the axis, positive [m]
/// \return the capsule \throws InvalidInput if one is not positive and finite \ingroup detection
Capsule makeCapsule(Real radius, Real halfLength);

/// A cylinder along z. \param radius positive [m] \param halfHeight positive [m]
/// \return the cylinder \throws InvalidInput if one is not positive and finite \ingroup detection
Cylinder makeCylinder(Real radius, Real halfHeight);

/// A half-space. \param normal out of the solid, any length but zero [1, body]
/// \param point any point on its plane [m, body] \return the half-space, its normal of length one
/// \throws InvalidInput if a number is not finite or the normal is zero \ingroup detection
HalfSpace makeHalfSpace(const Vector3& normal, const Vector3& point);

/// A compound. \param parts at least one, each usable \return the compound
/// \throws InvalidInput if there are no parts or one is not usable \ingroup detection
Compound makeCompound(std::vector<CompoundPart> parts);

/// Refuses a shape that cannot be worked with. \param shape any shape
/// \throws InvalidInput naming the value and the rule \ingroup detection
void requireUsable(const Shape& shape);

}  // namespace carom
