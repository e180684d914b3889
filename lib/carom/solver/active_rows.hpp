#pragma once
// A few contacts as a matrix, and what impulses stop some of them.
//
// Impulses x of all rows change the parting speeds from b to A x + b. A is as large as there are
// rows; its entry (i, j) is what a unit of impulse of row j does to the speed of row i.
// Method: one column of A at a time, by pushing a row and looking. A chosen few of the rows are
// brought to their targets by elimination with pivots.
// Why pushing and looking: it cannot disagree with what pushRow() does.
// Not handled: more than a dozen rows; linear_complementarity.hpp does that.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "carom/solver/contact_row.hpp"

namespace carom {

/// Rows as an equation. \ingroup solver
struct RowProblem {
  std::vector<Real> matrix;  ///< A, row after row, as many as there are rows squared [1/kg]
  std::vector<Real> speeds;  ///< b: parting speed before any impulse, less the target [m/s]
};

/// The equation of some rows. The impulses that they hold are taken for not applied.
/// \param bodies masses, and velocities before \param rows any
/// \return matrix and speeds \ingroup solver
RowProblem rowProblem(std::span<const MovingBody> bodies, std::span<const ContactRow> rows);

/// The impulses of chosen rows that bring just these to their targets.
/// \param matrix A, n times n, row after row [1/kg]
/// \param speeds b, n of them [m/s]
/// \param active bit i is set if row i may push
/// \return n impulses, zero for rows that may not push; nothing if the equations have no single
/// solution [N s]
/// \ingroup solver
std::optional<std::vector<Real>> stopRows(std::span<const Real> matrix,
                                          std::span<const Real> speeds, std::uint32_t active);

}  // namespace carom
