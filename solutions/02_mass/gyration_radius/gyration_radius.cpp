// Exercise 02.gyration_radius: how far from an axis the mass of a body lies.
// Check it with: ./course check 02.gyration_radius

#include "gyration_radius.hpp"

#include <Eigen/LU>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Real gyrationRadius(const MassProperties& body, const Vector3& axis) {
  requirePositive(body.mass, "mass");
  requirePositive(axis.norm(), "length of the axis");
  //# solution
  // The moment about one axis: the tensor between two copies of the unit axis.
  const Vector3 n = axis / axis.norm();
  const Real moment = n.dot(body.inertia * n);
  return std::sqrt(moment / body.mass);
  //# stub
  //#| // "You get the moment of inertia by taking the inverse of the tensor and multiplying it by an
  //#| // axis." So a school thesis says. Is it true?
  //#| const Matrix3 inverse = body.inertia.inverse();
  //#| const Real moment = (inverse * axis).norm();
  //#| return std::sqrt(moment / body.mass);
  //# end
}

}  // namespace carom
