// First how much, with the square of the speed, then where to.
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/impulse/drag_force.hpp"

namespace carom {

Vector3 dragForce(const Vector3& velocity, const AirDrag& air) {
  if (!velocity.allFinite() || !air.wind.allFinite() || !std::isfinite(air.density) ||
      !std::isfinite(air.coefficient) || !std::isfinite(air.area) || air.density < 0 ||
      air.coefficient < 0 || air.area < 0) {
    throw InvalidInput("dragForce: no such air");
  }
  const Vector3 headwind = air.wind - velocity;
  const Real speed = headwind.norm();
  if (speed == 0) return Vector3::Zero();
  const Real pressure = air.density * speed * speed / 2;
  return pressure * air.area * air.coefficient * (headwind / speed);
}

}  // namespace carom
