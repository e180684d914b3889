// Exercise 07.relative_to_origin: where is a body, seen from an origin that is far out with it?
// Check it with: ./course check 07.relative_to_origin

#include "carom/precision/relative_to_origin.hpp"

#include "carom/core/todo.hpp"

namespace carom {

Vector3 relativeToOrigin(const CellPosition& position, const CellPosition& origin) {
  // position.cell[0] is the cell along x, a whole number; position.offset(0) the offset along x.
  // static_cast<Real>(n) makes a number of a whole number n.
  return todo<Vector3>("relativeToOrigin");
}

}  // namespace carom
