#pragma once
// How large is a flat polygon, and where is its centre?
//
// Method: a fan of triangles around the middle of the corners; areas add up, and each triangle
// pulls the centre towards its own with the weight of its area.
// Why not the mean of the corners: it does not know how far the corners are apart. A square with
// one corner doubled would move its centre. Clipping makes corners wherever edges happen to cross,
// so the mean of a contact's corners jumps when one of them splits into two.
// A polygon that clipping has squeezed to a line or a point has no area to weigh with: then the
// edges weigh by their lengths, and a point is its own centre.
// Source: Bourke 1988 for the formula; the source's contact point of section 5.4.
// Not handled: polygons that cross themselves.

#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// The area of a flat polygon and its centre.
/// \ingroup manifold
struct PolygonArea {
  Real area = 0;                       ///< never negative [m^2]
  Vector3 centroid = Vector3::Zero();  ///< centre of the area [m]
};

/// Area and centroid of a flat convex polygon.
/// \param polygon corners in order, either way round, at least one; may lie on a line [m]
/// \return area and centroid; for a line the middle of it, for a point the point
/// \throws InvalidInput if there are no corners
/// \erratum{5.13}
/// \ingroup manifold
PolygonArea polygonCentroid(std::span<const Vector3> polygon);

}  // namespace carom
