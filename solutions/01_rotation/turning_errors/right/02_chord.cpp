// The angle by the chord between the two quaternions.
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
  const Quaternion e = renormalize(end);
  const Vector4 wanted(e.w, e.x, e.y, e.z);
  for (const int steps : counts) {
    const Real dt = duration / steps;
    Quaternion q = start;
    for (int i = 0; i < steps; ++i) q = step(q, i * dt, dt);
    const Quaternion u = renormalize(q);
    const Vector4 got(u.w, u.x, u.y, u.z);
    const Real chord = std::min((got - wanted).norm(), (got + wanted).norm());
    table.push_back({steps, dt, 4 * std::asin(chord / 2)});
  }
  return table;
}

}  // namespace carom
