#include "carom/precision/relative_to_origin.hpp"

namespace carom {

Vector3 relativeToOrigin(const CellPosition& position, const CellPosition& origin) {
  return position.offset - origin.offset;
}

}  // namespace carom
