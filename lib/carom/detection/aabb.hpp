#pragma once
// A box around a body whose sides stay along the world's axes.
//
// Method: the smallest and the largest coordinate along each axis. Two numbers per axis say where a
// body can be, and six comparisons throw most pairs of a scene out.
// Why closed: a box that just touches another is kept, so that a contact is not lost to rounding.
// Not handled here: making the box of a shape under a pose (bounds.hpp); trees of boxes (chapter
// 8).

#include <limits>

#include "carom/core/real.hpp"

namespace carom {

/// An axis-aligned box, in the plane or in space. Default: empty, holds no point.
/// \tparam Dim 2 or 3
/// \ingroup detection
template <int Dim>
struct Aabb {
  /// A column of Dim numbers.
  using Vector = Eigen::Matrix<Real, Dim, 1>;
  /// Smallest coordinates [m, world].
  Vector low = Vector::Constant(std::numeric_limits<Real>::infinity());
  /// Largest coordinates [m, world].
  Vector high = Vector::Constant(-std::numeric_limits<Real>::infinity());
};

/// Do two closed boxes have a common point? The inline twin of aabbOverlap() for loops that need
/// no verdict.
/// \tparam Dim 2 or 3
/// \param a one box [m] \param b another, in the same frame [m] \return true if they share a point
/// \ingroup detection
template <int Dim>
bool meets(const Aabb<Dim>& a, const Aabb<Dim>& b) {
  // & and not &&: six comparisons without a branch are faster than guessing which one fails.
  int all = 1;
  for (int i = 0; i < Dim; ++i) all &= int(a.high(i) >= b.low(i)) & int(b.high(i) >= a.low(i));
  return all != 0;
}

/// The smallest box around two boxes.
/// \tparam Dim 2 or 3
/// \param a one box [m] \param b another, in the same frame [m] \return the box around both
/// \ingroup detection
template <int Dim>
Aabb<Dim> joined(const Aabb<Dim>& a, const Aabb<Dim>& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

/// The smallest box around a box and a point.
/// \tparam Dim 2 or 3
/// \param box the box [m] \param point in the same frame [m] \return the box around both
/// \ingroup detection
template <int Dim>
Aabb<Dim> joined(const Aabb<Dim>& box, const typename Aabb<Dim>::Vector& point) {
  return {box.low.cwiseMin(point), box.high.cwiseMax(point)};
}

/// Does a closed box hold all points of another?
/// \tparam Dim 2 or 3
/// \param outer the box that may hold [m] \param inner the box that may be held [m]
/// \return true if no point of inner is outside outer
/// \ingroup detection
template <int Dim>
bool holds(const Aabb<Dim>& outer, const Aabb<Dim>& inner) {
  return (outer.low.array() <= inner.low.array()).all() &&
         (outer.high.array() >= inner.high.array()).all();
}

}  // namespace carom
