#pragma once
// When do a vertex and a face, or two edges, meet for the first time: without any rounding?
//
// The coordinates become whole numbers, the cubic and the areas of moving_points.hpp polynomials
// with whole coefficients. Each root of the cubic in [0, 1] is a candidate, judged by the exact
// signs of the areas there. If the cubic is zero at all times (everything moves in one plane, case
// T8) the features can only come to touch when an area changes its sign, so the roots of the areas
// are the candidates; if those are zero too (everything moves along one line), the roots of the
// differences of coordinates.
// Why not always: ten to a hundred microseconds. It decides what the filter of feature_impact.hpp
// leaves open, and judges the filter in tests.
// Not handled: nothing, as long as the coordinates are finite; numbers that differ by hundreds of
// powers of ten take longer.

#include <optional>

#include "carom/toi/moving_points.hpp"

namespace carom {

/// The first time at which two features touch, exactly.
/// \param pair kind of the features
/// \param points moving from time 0 to 1; any, also with triangles and edges without extent
/// \return the largest double that is not above the first time of contact; nothing if they do not
///   touch in [0, 1]
/// \throws InvalidInput if a coordinate is not finite
/// \erratum{8.5}
/// \ingroup toi
std::optional<Real> exactFirstContact(FeaturePair pair, const MovingPoints& points);

/// The sign of the cubic of four points at a time, exactly.
/// \param pair kind of the features \param points any finite ones \param time from 0 to 1
/// \return sign of A . (B x C) \ingroup toi
int exactVolumeSign(FeaturePair pair, const MovingPoints& points, Real time);

}  // namespace carom
