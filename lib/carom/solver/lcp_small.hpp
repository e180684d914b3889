#pragma once
// What exactly would the impulses be, if one could try everything?
//
// The question: impulses x change the parting speeds from b to s = A x + b. No impulse pulls,
// nobody approaches, and who parts is not pushed: x >= 0, s >= 0, and x_i s_i = 0 for each i. That
// is a linear complementarity problem.
// Method: each row either pushes or does not. Try all 2^n choices; in each, the rows that push stop,
// which is a system of linear equations. A choice is right if no impulse pulls and no other row
// approaches.
// Why try everything: nothing is simpler to believe. For eight rows that is 256 small systems, and
// this function is the judge of those that are fast.
// Source: Cottle, Pang and Stone 1992, section 1.1; Baraff 1994.
// Not handled: more than 12 rows; for those solveComplementarity() (chapter 5).

#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// The exact impulses of a few rows.
/// \param matrix A, n times n, row after row, symmetric and positive semi-definite [1/kg]
/// \param speeds b, n of them, at most 12 [m/s]
/// \return n impulses; of several solutions one [N s]
/// \throws InvalidInput if sizes do not fit, there are more than 12 rows, or there is no solution
/// \ingroup solver
std::vector<Real> lcpSmall(std::span<const Real> matrix, std::span<const Real> speeds);

}  // namespace carom
