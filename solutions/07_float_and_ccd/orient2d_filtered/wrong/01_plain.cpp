#include "carom/precision/orient2d_filtered.hpp"

#include <cmath>

#include "carom/precision/exact_orient2d.hpp"

namespace carom {

FilteredSign orient2dFiltered(const Vector2& a, const Vector2& b, const Vector2& c) {
  const Real left = (a.x() - c.x()) * (b.y() - c.y());
  const Real right = (a.y() - c.y()) * (b.x() - c.x());
  const Real value = left - right;
  return {(value > 0) - (value < 0), true};
}

}  // namespace carom
