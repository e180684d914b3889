#pragma once
// Cylinders and capsules that stand side by side, or on top of each other, or inside each other.
//
// Method: where the axes are parallel, the difference of two cylinders is again a cylinder, with the
// sums of the radii and of the heights; the signed distance is that of one point to its surface. A
// capsule's core is a cylinder of radius zero.
// Why: standing cylinders are the rule in a scene of cylinders, and one about the axis of another is
// the worst case of EPA, because all sideways ways out are equally long.
// Not handled: axes that are not parallel to the last bits; GJK and EPA do those.

#include "carom/core/real.hpp"
#include "carom/detection/core_shape.hpp"
#include "carom/detection/separation.hpp"

namespace carom::detail {

/// The signed distance of two cores with parallel axes.
/// \param a segment or cylinder \param R_WA its rotation
/// \param b segment or cylinder, one of the two a cylinder \param R_WB its rotation
/// \param p_AB B's origin from A's [m, world axes]
/// \param result receives separation, normal and points, from A's origin along the world's axes
/// \return false, and nothing done, if the cores are others or their axes not parallel
bool separateParallel(const CoreShape& a, const Matrix3& R_WA, const CoreShape& b,
                      const Matrix3& R_WB, const Vector3& p_AB, Separation& result);

}  // namespace carom::detail
