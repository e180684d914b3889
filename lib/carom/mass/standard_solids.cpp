#include "carom/mass/standard_solids.hpp"

#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/mass/box_inertia.hpp"
#include "carom/mass/combine_bodies.hpp"

namespace carom {
namespace {

constexpr Real kPi = std::numbers::pi;

void requirePositive(const char* solid, std::initializer_list<Real> values) {
  for (const Real value : values) {
    if (!(value > 0) || !std::isfinite(value)) {
      throw InvalidInput(std::string(solid) +
                         ": lengths and density must be positive and finite, but one is " +
                         std::to_string(value));
    }
  }
}

// A body about its own centre at the origin whose axes are principal.
MassProperties aboutOrigin(Real volume, Real density, const Vector3& inertiaPerMass) {
  MassProperties body;
  body.volume = volume;
  body.mass = density * volume;
  body.inertia.diagonal() = body.mass * inertiaPerMass;
  return body;
}

}  // namespace

MassProperties solidBall(Real radius, Real density) {
  requirePositive("solidBall", {radius, density});
  return aboutOrigin(4 * kPi / 3 * radius * radius * radius, density,
                     Vector3::Constant(2 * radius * radius / 5));
}

MassProperties hollowBall(Real innerRadius, Real outerRadius, Real density) {
  requirePositive("hollowBall", {outerRadius, density});
  if (!(innerRadius >= 0 && innerRadius < outerRadius)) {
    throw InvalidInput("hollowBall: needs 0 <= innerRadius < outerRadius, but they are " +
                       std::to_string(innerRadius) + " and " + std::to_string(outerRadius));
  }
  // (R³ - r³) and (R⁵ - r⁵) with R - r divided out, so that a thin wall keeps its digits; both
  // ratios are then sums of positive terms. As r tends to R the inertia tends to 2/3 m R², that of
  // a shell.
  const Real R = outerRadius;
  const Real r = innerRadius;
  const Real cubes = R * R + R * r + r * r;
  const Real fifths = R * R * R * R + R * R * R * r + R * R * r * r + R * r * r * r + r * r * r * r;
  return aboutOrigin(4 * kPi / 3 * (R - r) * cubes, density,
                     Vector3::Constant(2 * fifths / (5 * cubes)));
}

MassProperties solidBox(const Vector3& size, Real density) {
  requirePositive("solidBox", {size.x(), size.y(), size.z(), density});
  MassProperties body;
  body.volume = size.x() * size.y() * size.z();
  body.mass = density * body.volume;
  body.inertia = boxInertia(body.mass, size);
  return body;
}

MassProperties solidEllipsoid(const Vector3& semiAxes, Real density) {
  requirePositive("solidEllipsoid", {semiAxes.x(), semiAxes.y(), semiAxes.z(), density});
  const Vector3 squares = semiAxes.cwiseProduct(semiAxes);
  return aboutOrigin(
      4 * kPi / 3 * semiAxes.x() * semiAxes.y() * semiAxes.z(), density,
      Vector3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y()) / 5);
}

MassProperties solidCylinder(Real radius, Real height, Real density) {
  requirePositive("solidCylinder", {radius, height, density});
  const Real across = (3 * radius * radius + height * height) / 12;
  return aboutOrigin(kPi * radius * radius * height, density,
                     {across, across, radius * radius / 2});
}

MassProperties solidCapsule(Real radius, Real height, Real density) {
  requirePositive("solidCapsule", {radius, density});
  if (!(height >= 0) || !std::isfinite(height)) {
    throw InvalidInput("solidCapsule: height must be at least zero, but is " +
                       std::to_string(height));
  }
  if (height == 0) return solidBall(radius, density);

  // A half ball, flat side down: its centre lies 3/8 r above the flat side, its inertia about that
  // centre is 83/320 m r² across and 2/5 m r² along.
  MassProperties cap;
  cap.volume = 2 * kPi / 3 * radius * radius * radius;
  cap.mass = density * cap.volume;
  cap.inertia.diagonal() =
      cap.mass * radius * radius * Vector3(Real(83) / 320, Real(83) / 320, Real(2) / 5);
  cap.center.z() = height / 2 + 3 * radius / 8;
  MassProperties lower = cap;
  lower.center = -cap.center;
  return combineBodies(std::array{lower, solidCylinder(radius, height, density), cap});
}

MassProperties solidCone(Real radius, Real height, Real density) {
  requirePositive("solidCone", {radius, height, density});
  const Real across = 3 * (4 * radius * radius + height * height) / 80;
  MassProperties body = aboutOrigin(kPi / 3 * radius * radius * height, density,
                                    {across, across, 3 * radius * radius / 10});
  body.center.z() = height / 4;
  return body;
}

MassProperties solidTetrahedron(const Vector3& a, const Vector3& b, const Vector3& c,
                                const Vector3& d, Real density) {
  requirePositive("solidTetrahedron", {density});
  const Real sixV = std::abs((b - a).dot(cross(c - a, d - a)));
  if (!(sixV > 0) || !std::isfinite(sixV)) {
    throw InvalidInput("solidTetrahedron: the corners must be finite and not lie in one plane");
  }
  MassProperties body;
  body.volume = sixV / 6;
  body.mass = density * body.volume;
  const Vector3 fromA = ((b - a) + (c - a) + (d - a)) / 4;
  body.center = a + fromA;

  // The same second moments as four points of mass m/20 in the corners and 16 m/20 in the centre.
  Matrix3 C = fromA * fromA.transpose();
  for (const Vector3& corner : {b, c, d}) {
    const Vector3 r = (corner - a) - fromA;
    C += r * r.transpose();
  }
  C *= body.mass / 20;
  body.inertia = C.trace() * Matrix3::Identity() - C;
  return body;
}

MassProperties solidTorus(Real ringRadius, Real tubeRadius, Real density) {
  requirePositive("solidTorus", {ringRadius, tubeRadius, density});
  if (tubeRadius > ringRadius) {
    throw InvalidInput("solidTorus: the tube must not reach over the axis, but tubeRadius " +
                       std::to_string(tubeRadius) + " > ringRadius " + std::to_string(ringRadius));
  }
  const Real RR = ringRadius * ringRadius;
  const Real rr = tubeRadius * tubeRadius;
  const Real across = RR / 2 + 5 * rr / 8;
  return aboutOrigin(2 * kPi * kPi * ringRadius * rr, density, {across, across, RR + 3 * rr / 4});
}

}  // namespace carom
