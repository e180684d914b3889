#include "stopping_errors.hpp"

#include "carom/core/checks.hpp"
#include "carom/impulse/friction_impulse.hpp"

namespace carom {

std::vector<StoppingError> stoppingErrors(Real speed, Real friction, std::span<const Real> steps) {
  requirePositive(speed, "speed");
  requirePositive(friction, "friction");
  const Real exact = speed * speed / (2 * friction * kFloorGravity);
  std::vector<StoppingError> table;
  for (const Real h : steps) {
    requirePositive(h, "step");
    Vector3 v(speed, 0, 0);
    Real x = 0;
    while (v.x() > 0) {
      // A crate of 1 kg, pressed on by its weight for the time h.
      v += frictionImpulse(v, Vector3::UnitZ(), kFloorGravity * h, friction, 1);
      x += h * v.x();
    }
    table.push_back({h, x, x - exact});
  }
  return table;
}

}  // namespace carom
