// The squared length of the axis is divided out at the end.
#include "gyration_radius.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Real gyrationRadius(const MassProperties& body, const Vector3& axis) {
  requirePositive(body.mass, "mass");
  requirePositive(axis.norm(), "axis");
  Real sum = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) sum += axis[i] * body.inertia(i, j) * axis[j];
  }
  return std::sqrt(sum / (body.mass * axis.dot(axis)));
}

}  // namespace carom
