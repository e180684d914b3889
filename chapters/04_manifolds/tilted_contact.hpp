#pragma once
// How much does a contact change when the body tilts by next to nothing?
//
// Method: lay the bottom of a box on a floor, tilted by an angle to one side and then to the other,
// and compare the two contacts that faceContact() gives: where their lowest points are, and how
// deep their points are, one by one.
// Why both: a single contact point is a place, and places jump; the manifold is four places that
// stay, with depths that change by as little as the box tilts.
// Source: section 5.4 of the source text and its one contact point.
// Not handled: a tilt so large that one side leaves the floor.

#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// What changes when a box that tilts to one side tilts as far to the other. \ingroup manifold
struct TiltedContact {
  Real tilt = 0;         ///< angle to either side [rad]
  Real jump = 0;         ///< how far along x the lowest contact point moves [m]
  Real depthChange = 0;  ///< largest change of the depth of any one of the points [m]
};

/// Measures how a contact depends on a tilt about y.
/// \param halfWidth half of the box's width along x, positive [m]
/// \param depth of the level box in the floor, positive [m]
/// \param tilts angles to try, each positive and below depth / halfWidth [rad]
/// \return one row for each tilt, in the order given
/// \throws InvalidInput if a number is not positive, or a tilt lifts one side out of the floor
/// \ingroup manifold
std::vector<TiltedContact> tiltedContact(Real halfWidth, Real depth, std::span<const Real> tilts);

}  // namespace carom
