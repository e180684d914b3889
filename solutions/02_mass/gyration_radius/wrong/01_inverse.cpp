#include "gyration_radius.hpp"

#include <Eigen/LU>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Real gyrationRadius(const MassProperties& body, const Vector3& axis) {
  requirePositive(body.mass, "mass");
  requirePositive(axis.norm(), "length of the axis");
  const Real moment = (body.inertia.inverse() * axis).norm();
  return std::sqrt(moment / body.mass);
}

}  // namespace carom
