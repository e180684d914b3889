#pragma once
// What can doubles say for certain about the first contact of two features?
//
// Step 1 and 2 of feature_impact.hpp. Every polynomial is a double with a bound on its error; a
// sign counts only beyond the bound. The bounds are 2^-47 m m for areas and 2^-45 m m m for the
// volume, where m are the largest coordinates of the vectors that are multiplied: u = 2^-53 is
// lost in each difference, product and sum, at most 52 of them on the way to an area on an
// interval of time (each at most twice the product of the m), and 126 to a volume. With numbers of
// twice the digits it is 2^-92 m m m.
// Not handled: coordinates so large or small that a product leaves the range of a double; these
// stay open.

#include "carom/toi/moving_points.hpp"

namespace carom {

/// What is certain after the filter. \ingroup toi
enum class FilterVerdict {
  kMiss,  ///< no contact
  kHit,   ///< contact, for the first time at the time given
  kOpen,  ///< not decided
};

/// The answer of the filter. \ingroup toi
struct Filtered {
  FilterVerdict verdict = FilterVerdict::kOpen;  ///< what is certain
  Real time = 0;                                 ///< of a hit: the exact time, rounded down
  bool neededExact = false;  ///< whether the last digit of the time took whole numbers
};

/// Does a coordinate axis keep the features apart all the time? Exact: it only compares.
/// \param pair kind of the features \param points moving from time 0 to 1, finite
/// \return true if on one axis all of one feature are above all of the other, at both ends
/// \ingroup toi
bool axisKeepsApart(FeaturePair pair, const MovingPoints& points);

/// Looks for the first contact in doubles with error bounds.
/// \param pair kind of the features \param points moving from time 0 to 1, finite
/// \return a certain answer, or that it is open
/// \ingroup toi
Filtered filterContact(FeaturePair pair, const MovingPoints& points);

}  // namespace carom
