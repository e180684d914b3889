#pragma once
// Where is something that is very far away?
//
// A position is kept in two parts: a whole number of cells, which is exact, and the place within
// the cell, which is small and therefore fine. Within a cell of 1024 m a double is good to 1e-13 m
// and a float to 0.06 mm, wherever the cell is: at 10 000 km as at the origin. The size is a power
// of two, so that passing from cell to cell rounds nothing that the offset had not rounded. It costs
// three whole numbers per body and one comparison per coordinate and step. Games do it so, or keep
// the camera at the origin and move the world (Thorne, Journal of Ubiquitous Computing and
// Intelligence 1, 2007). What it does not handle: more than 2^53 cells.

#include <array>
#include <cstdint>
#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// Edge of a cell [m]. Larger: fewer changes of cell; smaller: finer floats.
/// \ingroup precision
constexpr Real kCellSize = 1024;

/// A position as cell and offset: cell * kCellSize + offset. \tparam Number float or double
/// \ingroup precision
template <class Number>
struct BasicCellPosition {
  std::array<std::int64_t, 3> cell = {};  ///< which cell, along x, y and z; cell 0 is the origin's
  /// From the middle of the cell [m, world]; at most half a cell along each axis
  Eigen::Matrix<Number, 3, 1> offset = Eigen::Matrix<Number, 3, 1>::Zero();
};

/// A position good to 1e-13 m everywhere. \ingroup precision
using CellPosition = BasicCellPosition<Real>;
/// A position good to 0.06 mm everywhere, in floats. \ingroup precision
using FloatCellPosition = BasicCellPosition<float>;

/// Cell and offset of a position given as one vector. Exact, within the digits that the vector has.
/// \param position [m, world]
/// \return the same position
/// \throws InvalidInput if a coordinate is not finite, or beyond 2^53 cells
/// \ingroup precision
CellPosition cellPosition(const Vector3& position);

/// Moves a position. \param from where it was \param by displacement [m, world]
/// \return where it is then; its offset is rounded once
/// \throws InvalidInput if the displacement is not finite, or leads beyond 2^53 cells
/// \ingroup precision
CellPosition moved(const CellPosition& from, const Vector3& by);

/// Moves a position in floats. \param from where it was \param by displacement [m, world]
/// \return where it is then; its offset is rounded once
/// \throws InvalidInput if the displacement is not finite, or leads beyond 2^53 cells
/// \ingroup precision
FloatCellPosition moved(const FloatCellPosition& from, const Eigen::Matrix<float, 3, 1>& by);

/// The same position with its offset in doubles. \param position in floats \return it, exactly
/// \ingroup precision
CellPosition inDoubles(const FloatCellPosition& position);

/// Moves the origin of a world whose positions are kept relative to it, so that what is looked at
/// stays near it. The origin moves by whole cells, so a position that comes nearer to it is not
/// rounded at all.
/// \param origin position of the origin; becomes the cell nearest to the anchor
/// \param anchor where to move it: the camera, or the player [m, relative to the old origin]
/// \param positions of all bodies [m, relative to the old origin]; become relative to the new one
/// \throws InvalidInput if the anchor is not finite or beyond 2^53 cells; nothing has changed then
/// \ingroup precision
void moveOrigin(CellPosition& origin, const Vector3& anchor, std::span<Vector3> positions);

}  // namespace carom
