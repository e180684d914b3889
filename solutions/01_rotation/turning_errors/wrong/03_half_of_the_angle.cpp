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
    const Real dt = duration / steps;
    Quaternion q = start;
    for (int i = 0; i < steps; ++i) q = step(q, i * dt, dt);
    table.push_back(
        {steps, dt, length(quaternionLogarithm(hamiltonProduct(conjugate(end), q))) / 2});
  }
  return table;
}

}  // namespace carom
