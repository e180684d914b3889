#pragma once
// When are four moving points in one plane?
//
// If each moves in a straight line, their determinant is a cubic in time, and its roots in a step
// are the times at which a corner may meet a face, or an edge an edge (Provot, Graphics Interface
// 1997). A root that is missed is a body that passes through a wall, so no root is missed here.
// Between two neighbouring extrema a polynomial is monotone and has a root if and only if its signs
// at the ends differ. The extrema are the roots of its derivative, found in the same way, down to
// the constant. Every sign is exact: a rounded value is trusted beyond its error bound, otherwise
// the terms are added without error (ExactSum). Newton's method finds the root quickly, but what is
// returned is a bracket: two neighbouring doubles with a root between them.
//
// Why not Cardano's formula: it cancels for roots that are nearly equal, and says nothing about
// its error. What it does not handle: |x| beyond 2^100.

#include <array>

#include "carom/core/real.hpp"

namespace carom {

/// Where a polynomial is zero. \ingroup precision
struct RootBracket {
  Real low = 0;          ///< the last double not above the root
  Real high = 0;         ///< the first double not below the root; low, if that is the root itself
  bool crossing = true;  ///< the sign changes, or is 0 at a double. False: the polynomial comes
                         ///< within rounding of zero between two doubles, and may touch it or not
};

/// The real roots of a cubic in an interval, in increasing order. \ingroup precision
struct CubicRoots {
  int count = 0;                          ///< how many brackets there are
  bool everywhere = false;                ///< all coefficients are 0: no bracket, all numbers solve
  std::array<RootBracket, 10> roots = {};  ///< the first `count` of them hold something
};

/// Solves c0 + c1 x + c2 x^2 + c3 x^3 = 0 for x in an interval. Leading coefficients may be 0. A
/// multiple root appears once. No root is missed; roots closer to each other than neighbouring
/// doubles share a bracket, and a near miss of less than about 1e-31 of the terms is listed with
/// `crossing` false.
/// \param coefficients c0, c1, c2, c3 [any unit]
/// \param from least x \param to largest x, not below `from`; both within 2^100
/// \return brackets of all roots in the interval, each between neighbouring doubles
/// \throws InvalidInput if a coefficient is not finite, or the interval is not as said
/// \ingroup precision
CubicRoots cubicRoots(const std::array<Real, 4>& coefficients, Real from, Real to);

}  // namespace carom
