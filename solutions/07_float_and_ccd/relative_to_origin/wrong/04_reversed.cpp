#include "carom/precision/relative_to_origin.hpp"

namespace carom {

Vector3 relativeToOrigin(const CellPosition& position, const CellPosition& origin) {
  Vector3 difference = origin.offset - position.offset;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    difference(i) += static_cast<Real>(origin.cell[k] - position.cell[k]) * kCellSize;
  }
  return difference;
}

}  // namespace carom
