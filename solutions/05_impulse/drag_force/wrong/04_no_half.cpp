// Exercise 05.drag_force: how does the air brake a body?
// Check it with: ./course check 05.drag_force

#include "carom/impulse/drag_force.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"

namespace carom {

Vector3 dragForce(const Vector3& velocity, const AirDrag& air) {
  // Given: what cannot be is refused.
  requireFinite(velocity, "velocity");
  requireFinite(air.wind, "wind");
  requireNonNegative(air.density, "density");
  requireNonNegative(air.coefficient, "coefficient");
  requireNonNegative(air.area, "area");
  const Vector3 w = velocity - air.wind;
  return -air.density * air.coefficient * air.area * length(w) * w;
}

}  // namespace carom
