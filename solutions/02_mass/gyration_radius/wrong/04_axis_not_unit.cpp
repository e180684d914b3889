#include "gyration_radius.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Real gyrationRadius(const MassProperties& body, const Vector3& axis) {
  requirePositive(body.mass, "mass");
  requirePositive(axis.norm(), "length of the axis");
  const Vector3 n = axis;
  const Real moment = n.dot(body.inertia * n);
  return std::sqrt(moment / body.mass);
}

}  // namespace carom
