#include "carom/precision/relative_to_origin.hpp"

namespace carom {

Vector3 relativeToOrigin(const CellPosition& position, const CellPosition& origin) {
  Vector3 difference = position.offset - origin.offset;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    difference(i) += (static_cast<Real>(position.cell[k] - origin.cell[k]) + 0.5) * kCellSize;
  }
  return difference;
}

}  // namespace carom
