#pragma once
// The flat siblings: which figures does the library know in the plane?
//
// Method: the disc, the convex polygon, and compounds of them; the source's circles, polygons and
// Pacman. Corners run counter-clockwise, so that the outward normal of an edge is the edge turned
// clockwise by a right angle.
// Not handled: concave polygons in one piece; makePolygon() names the corner that is not convex.

#include <span>
#include <variant>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/detection/pose.hpp"

namespace carom {

/// All points of the plane within a radius of the body's origin. \ingroup detection
struct Disc {
  Real radius = 1;  ///< positive [m]
};

/// A convex polygon. \ingroup detection
struct Polygon {
  std::vector<Vector2> vertices;  ///< corners, counter-clockwise, at least 3 [m, body]
  std::vector<Vector2> normals;   ///< outward unit normal of the edge from corner i to i + 1 [1]
};

/// A convex figure: what a planar compound is made of. \ingroup detection
using ConvexPlanarShape = std::variant<Disc, Polygon>;

/// One convex part of a planar compound. \ingroup detection
struct PlanarCompoundPart {
  ConvexPlanarShape shape;  ///< the part in its own frame
  PlanarPose pose;          ///< body from part
};

/// A figure made of convex parts that are rigidly joined; they may overlap. \ingroup detection
struct PlanarCompound {
  std::vector<PlanarCompoundPart> parts;  ///< at least one
};

/// Any figure. \ingroup detection
using PlanarShape = std::variant<Disc, Polygon, PlanarCompound>;

/// A disc. \param radius positive [m] \return the disc
/// \throws InvalidInput if the radius is not positive and finite \ingroup detection
Disc makeDisc(Real radius);

/// A convex polygon with its normals. The turn at each corner is decided exactly.
/// \param vertices corners, counter-clockwise, at least 3 [m, body]
/// \return the polygon, corners as given
/// \throws InvalidInput if a number is not finite, a corner is not a left turn (concave, straight
///   or doubled), or the corners run round more than once; the message names the corner
/// \ingroup detection
Polygon makePolygon(std::span<const Vector2> vertices);

/// A planar compound. \param parts at least one, each usable \return the compound
/// \throws InvalidInput if there are no parts or one is not usable \ingroup detection
PlanarCompound makePlanarCompound(std::vector<PlanarCompoundPart> parts);

}  // namespace carom
