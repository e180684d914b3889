#pragma once
// Which value belongs beside which x?
//
// Method: y' = 1 + y^2 from y(0) = 0, whose solution is the tangent, in steps of Runge and Kutta's
// method. The first row is the start, where no step has been made; then a step, and a row, as often
// as there are steps.
// Why count: adding a tenth ten times gives 0.9999999999999999, so a loop that asks whether x has
// passed the end makes a row too few or too many, as the roundings fall.
// Source: the listing of section 7.4, which makes the step first and prints the new y beside the
// old x: 1.963 for the tangent of 1, which is 1.557.
// Not handled: the pole at pi/2, which no step sees.

#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// A row of a table of the tangent. \ingroup motion
struct TangentRow {
  Real x = 0;  ///< the angle [rad]
  Real y = 0;  ///< its tangent [1]
};

/// A table of the tangent, by steps of Runge and Kutta's method.
/// \param end the last angle, positive and below pi/2 [rad]
/// \param steps how many from zero to there, at least one
/// \return steps + 1 rows: x from zero to the end, and y at that x
/// \throws InvalidInput if the end is not between zero and pi/2, or there is no step
/// \erratum{7.3,7.12}
/// \ingroup motion
std::vector<TangentRow> tangentRows(Real end, int steps);

}  // namespace carom
