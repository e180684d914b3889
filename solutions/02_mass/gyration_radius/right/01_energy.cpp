// Twice the kinetic energy at one radian per second.
#include "gyration_radius.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Real gyrationRadius(const MassProperties& body, const Vector3& axis) {
  requirePositive(body.mass, "mass");
  requirePositive(axis.squaredNorm(), "axis");
  const Vector3 omega = axis.normalized();
  const Vector3 L = body.inertia * omega;
  return std::sqrt(omega.dot(L) / body.mass);
}

}  // namespace carom
