#include "gyration_radius.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Real gyrationRadius(const MassProperties& body, const Vector3& axis) {
  requirePositive(body.mass, "mass");
  requirePositive(axis.norm(), "length of the axis");
  const Vector3 n = axis / axis.norm();
  const Real moment = (body.inertia * n).norm();
  return std::sqrt(moment / body.mass);
}

}  // namespace carom
