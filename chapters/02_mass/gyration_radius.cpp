#include "gyration_radius.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

//! [gyration]
Real gyrationRadius(const MassProperties& body, const Vector3& axis) {
  requirePositive(body.mass, "mass");
  requirePositive(axis.norm(), "length of the axis");
  // The moment about one axis: the tensor between two copies of the unit axis.
  const Vector3 n = axis / axis.norm();
  const Real moment = n.dot(body.inertia * n);
  return std::sqrt(moment / body.mass);
}
//! [gyration]

}  // namespace carom
