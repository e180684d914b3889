// Exercise 05.stopping_errors: measure where a sliding crate stops, with steps of any length.
// Check it with: ./course check 05.stopping_errors

#include "stopping_errors.hpp"

#include "carom/core/checks.hpp"
#include "carom/impulse/friction_impulse.hpp"

namespace carom {

std::vector<StoppingError> stoppingErrors(Real speed, Real friction, std::span<const Real> steps) {
  // Given: what cannot be measured is refused.
  requirePositive(speed, "speed");
  requirePositive(friction, "friction");
  for (const Real h : steps) requirePositive(h, "step");
  std::vector<StoppingError> table;
  const Real exact = speed * speed / (friction * kFloorGravity);
  for (const Real h : steps) {
    Vector3 v(speed, 0, 0);
    Real x = 0;
    while (v.x() > 0) {
      v += frictionImpulse(v, Vector3::UnitZ(), kFloorGravity * h, friction, 1);
      x += h * v.x();
    }
    table.push_back({h, x, x - exact});
  }
  return table;
}

}  // namespace carom
