#pragma once
// A dot product as if computed with twice the digits.
//
// Products and sums are rounded in a plain dot product, and if the terms cancel only the rounding
// errors remain. Here both errors are computed exactly and added at the end: Dot2 of Ogita, Rump
// and Oishi (SIAM J. Sci. Comput. 26, 2005).

#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// a . b with an error of 1 ulp of the result plus n^2 2^-106 |a|.|b|.
/// \param a n numbers [any unit]
/// \param b n numbers [any unit]
/// \return the dot product [product of the units]
/// \throws InvalidInput if a and b differ in length
/// \ingroup precision
Real compensatedDot(std::span<const Real> a, std::span<const Real> b);

/// a . b of two vectors, with an error of 1 ulp of the result plus 9 * 2^-106 |a|.|b|.
/// \param a first vector [any unit]
/// \param b second vector [any unit, same frame]
/// \return the dot product [product of the units]
/// \ingroup precision
Real compensatedDot(const Vector3& a, const Vector3& b);

}  // namespace carom
