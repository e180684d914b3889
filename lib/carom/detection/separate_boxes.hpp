#pragma once
// Do two boxes overlap? Fast, and right to the last digit.
//
// Method: the fifteen axes of satBoxes() in the frame of A (box_axes.hpp). A gap that is within its
// own rounding error of zero is computed again with exact numbers, so that boxes that touch are
// called touching and boxes that are one unit in the last place apart are called apart. There the
// box is what its pose makes of it: the solid spanned by the columns of R_WB times the half
// extents, even if these columns are a rounding away from right angles.
// The answer does not depend on the order of the arguments: the pair is brought into an order of
// its own first, and the axis turned at the end.
// Temporal coherence: an axis that separated two boxes in the last step usually still does, and
// testing it costs a tenth of testing all. The verdict is the same.
// Source: Gottschalk, Lin and Manocha 1996; Shewchuk 1997 for filters; Baraff 1990 for the witness
// axis.
// Not handled: the distance of boxes whose nearest features are corners; that needs GJK.

#include "carom/core/real.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/separating_axis.hpp"
#include "carom/detection/shapes.hpp"

namespace carom {

/// The axis on which two boxes are farthest apart, or overlap least: as satBoxes(), with an exact
/// verdict.
/// \param a first box
/// \param A its pose
/// \param b second box
/// \param B its pose
/// \return verdict, signed gap, unit axis from A to B; features are numbers of box axes, 0 to 2.
///   Swapping the arguments swaps the features and turns the axis, and changes nothing else.
/// \ingroup detection
SeparatingAxis separateBoxes(const Box& a, const Pose& A, const Box& b, const Pose& B);

/// The axis that separated a pair the last time. \ingroup detection
struct WitnessAxis {
  int axis = -1;  ///< 0-2 normal of A, 3-5 normal of B, 6 + 3 i + j edges i and j; -1: none
};

/// Whether an axis still shows a gap between two boxes.
/// \param a first box
/// \param A its pose
/// \param b second box
/// \param B its pose
/// \param margin not negative [m]
/// \param witness axis to try, not none
/// \return true if it shows a gap above the margin, and rounding has no part in that
/// \ingroup detection
bool witnessSeparates(const Box& a, const Pose& A, const Box& b, const Pose& B, Real margin,
                      const WitnessAxis& witness);

/// Whether two boxes are more than a margin apart, on a witness axis if one is known.
/// \param a first box
/// \param A its pose
/// \param b second box
/// \param B its pose
/// \param margin not negative [m]
/// \param witness axis to try first; receives the axis found, or none
/// \return true if some axis shows a gap above the margin; the same with and without a witness
/// \ingroup detection
bool boxesAreApart(const Box& a, const Pose& A, const Box& b, const Pose& B, Real margin,
                   WitnessAxis& witness);

}  // namespace carom
