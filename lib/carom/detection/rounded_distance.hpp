#pragma once
// How far apart, or how deep in each other, are two solids, but for what rounding makes of it?
//
// Method: as signed_distance.hpp, without the exact verdict for polyhedra that touch.
// Why: who looks where bodies are at many times takes no memory for it, and a rounding decides
// nothing for him.
// Source: Ericson 2005; van den Bergen 2003.
// Not handled: the sign of a distance of a few roundings.

#include "carom/detection/pose.hpp"
#include "carom/detection/separation.hpp"
#include "carom/detection/shapes.hpp"

namespace carom {

/// The signed distance of two solids, right to a few roundings of where they are.
/// \param a usable shape of A \param A its pose
/// \param b usable shape of B \param B its pose
/// \return as signedDistance
/// \throws InvalidInput if a pose is not finite
/// \source{20,21,22}
/// \ingroup detection
Separation roundedDistance(const Shape& a, const Pose& A, const Shape& b, const Pose& B);

}  // namespace carom
