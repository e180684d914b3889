#pragma once
// Each of two bodies has its own bounciness. Which one does the pair have?
//
// Restitution is measured on pairs, so any rule for two coefficients is a convention. A rule is
// usable if its result stays from 0 to 1, is the same for (a, b) and (b, a), and gives e for two
// equal bodies of e; the product breaks the last one and is used all the same.
// Why never the sum: two balls of 0.8 would part with 1.6 times the speed at which they met, and
// each impact would multiply the energy of their approach by 2.56.
// Source: section 6.1, put right; engines take the product (Bullet) or the maximum (Box2D, Jolt).
// Not handled: restitution that falls with the speed of the impact, as that of real bodies does.

#include "carom/core/real.hpp"

namespace carom {

/// How two coefficients become one. \ingroup impulse
enum class RestitutionRule {
  average,       ///< (a + b) / 2
  product,       ///< a b
  minimum,       ///< the smaller one
  maximum,       ///< the larger one
  geometricMean  ///< the square root of a b
};

/// The coefficient of restitution of a pair.
/// \param a coefficient of one body, from 0 to 1 [1]
/// \param b coefficient of the other, from 0 to 1 [1]
/// \param rule how they are combined
/// \return coefficient of the pair, from 0 to 1 [1]
/// \throws InvalidInput if a coefficient is not from 0 to 1
/// \erratum{6.6}
/// \ingroup impulse
Real combineRestitution(Real a, Real b, RestitutionRule rule);

}  // namespace carom
