#include "carom/precision/relative_to_origin.hpp"

namespace carom {

Vector3 relativeToOrigin(const CellPosition& position, const CellPosition& origin) {
  Vector3 there, here;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    there(i) = static_cast<Real>(position.cell[k]) * kCellSize + position.offset(i);
    here(i) = static_cast<Real>(origin.cell[k]) * kCellSize + origin.offset(i);
  }
  return there - here;
}

}  // namespace carom
