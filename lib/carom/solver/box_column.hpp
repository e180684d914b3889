#pragma once
// The simplest stack: boxes one on the other that cannot turn or slide.
//
// Body 0 is the ground; box i stands on body i - 1, with one row between them. All that this chapter
// says about convergence can be seen on it, and computed by hand: the matrix of the rows has three
// diagonals.
// Not handled: anything that tips over.

#include <span>
#include <vector>

#include "carom/solver/contact_row.hpp"

namespace carom {

/// Bodies and rows of a column. \ingroup solver
struct BoxColumn {
  std::vector<MovingBody> bodies;  ///< the ground, and the boxes from below
  std::vector<ContactRow> rows;    ///< from below, named 0, 1, 2, ...
};

/// A column at rest that just touches.
/// \param masses of the boxes from below, each positive [kg]
/// \return bodies and rows; the normals point up, along z
/// \throws InvalidInput if a mass is not positive and finite
/// \ingroup solver
BoxColumn boxColumn(std::span<const Real> masses);

/// Lets gravity pull all boxes for a while. \param bodies their velocities are changed
/// \param change of velocity, negative: downwards [m/s, world z]
/// \ingroup solver
void pullDown(std::span<MovingBody> bodies, Real change);

}  // namespace carom
