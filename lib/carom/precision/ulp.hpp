#pragma once
// How far is it from a number to the next?
//
// A unit in the last place, ulp: numbers between two powers of two are evenly spaced, and at each
// power of two the spacing doubles. A coordinate of 1000 km is kept to 0.125 m in a float and to
// 2.3e-10 m in a double.

#include <cmath>
#include <limits>

#include "carom/core/real.hpp"

namespace carom {

/// The step from |x| to the next larger number; for the largest number, the step before it. The
/// source says that 64 bits only move the problem of coordinates far away; they move it by a factor
/// of 2^29, from metres to nanometres.
/// \erratum{8.3}
/// \tparam Number float or double
/// \param x any number
/// \return the spacing of the numbers at x [unit of x]; NaN if x is infinite or not a number
/// \ingroup precision
template <class Number>
Number ulp(Number x) {
  const Number size = std::abs(x);
  if (!std::isfinite(size)) return std::numeric_limits<Number>::quiet_NaN();
  if (size == std::numeric_limits<Number>::max()) return size - std::nextafter(size, Number(0));
  return std::nextafter(size, std::numeric_limits<Number>::infinity()) - size;
}

}  // namespace carom
