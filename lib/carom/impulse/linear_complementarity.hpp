#pragma once
// Which of several contacts push, and how hard, if each may push or part but not both?
//
// The question as numbers: given M and q find z >= 0 with w = M z + q >= 0 and z_i w_i = 0 for each
// i. For contacts z are impulses, w speeds of parting after it, q those before, M the matrix of how
// each impulse changes each speed.
// Method: Lemke's pivoting. An artificial variable makes everything feasible; as long as it is
// there, one pair (z_i, w_i) has both outside of the basis, and the one that did not just leave
// enters. Ties are broken by lexicographic order, so no basis comes twice and the method cannot
// cycle; it ends with a solution, or with a ray, which for a positive semi-definite M proves that
// there is none. The equations of the final basis are then solved once more and refined with twice
// the digits, so that the answer does not carry the roundings of the pivots, and contacts that
// mirror each other get the same impulse to the last bit.
// Why pivoting and not sweeps: it is exact after finitely many steps, also for redundant contacts
// and large ratios of mass. It is the judge of the iterative solver of chapter 9.
// Source: Lemke 1965; Cottle, Pang and Stone, The Linear Complementarity Problem, 1992, section 4.4
// and 4.9.
// Not handled: more than some hundred contacts, because a pivot costs n^2.

#include <span>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/impulse/dense_matrix.hpp"
#include "carom/precision/double_double.hpp"

namespace carom {

/// How the search for a solution ended. \ingroup impulse
enum class ComplementarityStatus {
  solved,      ///< z is a solution
  ray,         ///< no solution was found on the path; for positive semi-definite M there is none
  pivotLimit,  ///< more pivots than allowed; rounding must have broken the order
};

/// A solution of a linear complementarity problem. \ingroup impulse
struct Complementarity {
  ComplementarityStatus status = ComplementarityStatus::solved;  ///< how the search ended
  std::vector<Real> z;  ///< the solution, exactly zero where w is free; empty unless solved
  int pivots = 0;       ///< steps taken
  Real residual = 0;  ///< largest of -w_i, and of |w_i| where z_i > 0, beside the largest |q_i| [1]
};

/// Memory of a search, used again by the next one: who searches often asks for it once.
/// \ingroup impulse
struct ComplementarityMemory {
  DenseMatrix scaled;                 ///< M with a diagonal of about one
  DenseMatrix tableau;                ///< of the pivots
  DenseMatrix part;                   ///< rows and columns that push
  DenseMatrix eliminated;             ///< the same, taken apart
  std::vector<Real> scale;            ///< of each row
  std::vector<Real> scaledQ;          ///< q in these
  std::vector<Real> residual;         ///< of a refinement
  std::vector<Real> step;             ///< that it takes
  std::vector<DoubleDouble> refined;  ///< the solution with twice the digits
  std::vector<int> basis;             ///< variable of each row of the tableau
  std::vector<int> active;            ///< rows that push
  std::vector<int> order;             ///< of rows, in the elimination
};

/// Takes memory for searches up to a size. \param memory gets it \param result for answers, too
/// \param rows of the largest matrix \ingroup impulse
void reserve(ComplementarityMemory& memory, Complementarity& result, int rows);

/// Solves w = M z + q, z >= 0, w >= 0, z . w = 0.
/// \param M square matrix; a solution is found if it is positive semi-definite and there is one, or
/// if it is positive definite
/// \param q as many numbers as M has rows
/// \return solution and how it was found
/// \throws InvalidInput if M is not square, q has another length, or a number is not finite
/// \ingroup impulse
Complementarity solveComplementarity(const DenseMatrix& M, std::span<const Real> q);

/// The same without asking for memory, once what is given has its largest size.
/// \param M square matrix \param q as many numbers as M has rows
/// \param memory of any earlier search \param result takes the answer
/// \throws InvalidInput as the other one
/// \ingroup impulse
void solveComplementarity(const DenseMatrix& M, std::span<const Real> q,
                          ComplementarityMemory& memory, Complementarity& result);

}  // namespace carom
