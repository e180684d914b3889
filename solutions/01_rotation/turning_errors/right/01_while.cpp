// The time as a fraction of the duration, the angle by an arctangent.
#include "turning_errors.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/length.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

std::vector<TurningError> turningErrors(const TurningStep& step, const Quaternion& start,
                                        const Quaternion& end, Real duration,
                                        std::span<const int> counts) {
  std::vector<TurningError> table;
  for (const int steps : counts) {
    Quaternion q = start;
    int made = 0;
    while (made < steps) {
      q = step(q, duration * made / steps, duration / steps);
      ++made;
    }
    const Quaternion left = hamiltonProduct(q, conjugate(end));
    const Real sine = std::hypot(left.x, left.y, left.z);
    table.push_back({steps, duration / steps, 2 * std::atan2(sine, std::abs(left.w))});
  }
  return table;
}

}  // namespace carom
