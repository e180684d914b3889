#include "carom/precision/orient2d_filtered.hpp"

#include <cmath>

#include "carom/precision/exact_orient2d.hpp"

namespace carom {

FilteredSign orient2dFiltered(const Vector2& a, const Vector2& b, const Vector2& c) {
  return {exactOrient2d(a, b, c), false};
}

}  // namespace carom
