#include "carom/precision/cell_position.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {
namespace {

// Passes whole cells from the offset to the cell.
template <class Number>
BasicCellPosition<Number> carried(BasicCellPosition<Number> p) {
  constexpr std::int64_t kLast = std::int64_t{1} << 53;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Number cells = std::round(p.offset(i) / static_cast<Number>(kCellSize));
    if (cells != 0) {  // in few steps only
      if (!(std::abs(cells) < 0x1p53)) {
        reject("coordinate", toText(Real(p.offset(i))), "must be finite and within 2^53 cells");
      }
      p.cell[k] += static_cast<std::int64_t>(cells);
      p.offset(i) -= cells * static_cast<Number>(kCellSize);  // exact: what is left is a remainder
    }
    if (p.cell[k] > kLast || p.cell[k] < -kLast) {
      reject("cell", std::to_string(p.cell[k]), "must be within 2^53");
    }
  }
  return p;
}

}  // namespace

CellPosition cellPosition(const Vector3& position) {
  requireFinite(position, "position");
  return carried(CellPosition{{}, position});
}

CellPosition moved(const CellPosition& from, const Vector3& by) {
  requireFinite(by, "displacement");
  return carried(CellPosition{from.cell, from.offset + by});
}

FloatCellPosition moved(const FloatCellPosition& from, const Eigen::Matrix<float, 3, 1>& by) {
  requireFinite(Vector3(by.cast<Real>()), "displacement");
  return carried(FloatCellPosition{from.cell, from.offset + by});
}

CellPosition inDoubles(const FloatCellPosition& position) {
  return {position.cell, position.offset.cast<Real>()};
}

void moveOrigin(CellPosition& origin, const Vector3& anchor, std::span<Vector3> positions) {
  const CellPosition there = cellPosition(anchor);
  CellPosition next = origin;
  Vector3 by;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    next.cell[k] += there.cell[k];
    by(i) = static_cast<Real>(there.cell[k]) * kCellSize;
  }
  origin = carried(next);
  for (Vector3& p : positions) p -= by;
}

}  // namespace carom
