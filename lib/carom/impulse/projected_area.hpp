#pragma once
// How much of a body does the wind see?
//
// Method: a convex body's shadow is covered twice, by the faces towards the light and by those away
// from it. So its area is half the sum of A_i |n_i . d| over all faces. Ball, capsule and cylinder
// are the limits of that, in closed form.
// Why not a fixed number: a falling sheet offers the air all of its face or only its edge.
// Source: equation 34 asks for the projected area; Cauchy 1841 has the theorem.
// Not handled: concave bodies, whose parts stand in each other's shadow.

#include "carom/core/real.hpp"
#include "carom/detection/shapes.hpp"

namespace carom {

/// The area of a convex body's shadow.
/// \param shape usable convex shape
/// \param direction of the flow, any length but zero [any unit, body]
/// \return area perpendicular to the direction [m^2]
/// \throws InvalidInput if the direction is zero or not finite
/// \source{34}
/// \erratum{6.10}
/// \ingroup impulse
Real projectedArea(const ConvexShape& shape, const Vector3& direction);

}  // namespace carom
