#include "carom/impulse/drag_force.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"

namespace carom {

Vector3 dragForce(const Vector3& velocity, const AirDrag& air) {
  requireFinite(velocity, "velocity");
  requireFinite(air.wind, "wind");
  requireNonNegative(air.density, "density");
  requireNonNegative(air.coefficient, "coefficient");
  requireNonNegative(air.area, "area");

  const Vector3 throughAir = velocity - air.wind;
  return -air.density * air.coefficient * air.area / 2 * length(throughAir) * throughAir;
}

}  // namespace carom
