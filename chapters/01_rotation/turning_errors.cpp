#include "turning_errors.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"

namespace carom {

//! [turning_errors]
std::vector<TurningError> turningErrors(const TurningStep& step, const Quaternion& start,
                                        const Quaternion& end, Real duration,
                                        std::span<const int> counts) {
  requireFinite(duration, "duration");
  std::vector<TurningError> table;
  for (const int steps : counts) {
    if (steps < 1) reject("count", std::to_string(steps), "must be at least 1");
    const Real dt = duration / steps;
    Quaternion q = start;
    for (int i = 0; i < steps; ++i) q = step(q, i * dt, dt);

    const Vector3 turn = quaternionLogarithm(hamiltonProduct(conjugate(end), q));
    table.push_back({steps, dt, length(turn)});
  }
  return table;
}
//! [turning_errors]

}  // namespace carom
