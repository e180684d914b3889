#include "carom/precision/relative_to_origin.hpp"

namespace carom {

Vector3 relativeToOrigin(const CellPosition& position, const CellPosition& origin) {
  const auto along = [&](std::size_t k, int i) {
    const std::int64_t cells = position.cell[k] - origin.cell[k];
    return 1024.0 * static_cast<Real>(cells) + (position.offset(i) - origin.offset(i));
  };
  return {along(0, 0), along(1, 1), along(2, 2)};
}

}  // namespace carom
