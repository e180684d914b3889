#pragma once
// How is a b - c d computed when the two products are nearly equal?
//
// Each product is rounded, and if they agree in their first digits the difference holds little but
// the two rounding errors. Both errors can be computed exactly (twoProduct), and so the difference
// of the products is as good as if it had been rounded once (after Kahan; Jeannerod, Louvet and
// Muller, Math. Comp. 82, 2013, analyse his version with a fused multiply-add). Discriminants and
// cross products are made of such differences. What it does not handle: products outside 1e-290 to
// 1e300.

#include "carom/core/two_sum.hpp"
#include "carom/precision/double_double.hpp"

namespace carom {

/// a b - c d, with an error below 1 ulp of the result; its sign is exact, and it is 0 only if the
/// products are equal.
/// \param a first factor of the first product
/// \param b second factor of the first product
/// \param c first factor of the second product
/// \param d second factor of the second product; the range of twoProduct() applies
/// \return the difference
/// \ingroup precision
constexpr Real differenceOfProducts(Real a, Real b, Real c, Real d) {
  return (exactProduct(a, b) - exactProduct(c, d)).value();
}

/// The cross product of two vectors that may be nearly parallel: each component right to 1 ulp.
/// \param u first vector [any unit]
/// \param w second vector [any unit, same frame]
/// \return u x w [product of the units, same frame]
/// \ingroup precision
inline Vector3 compensatedCross(const Vector3& u, const Vector3& w) {
  return {differenceOfProducts(u.y(), w.z(), u.z(), w.y()),
          differenceOfProducts(u.z(), w.x(), u.x(), w.z()),
          differenceOfProducts(u.x(), w.y(), u.y(), w.x())};
}

}  // namespace carom
