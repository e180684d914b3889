#include "carom/impulse/body_motion.hpp"

#include <cmath>
#include <string>

#include "carom/core/checks.hpp"
#include "carom/impulse/positive_solve.hpp"
#include "carom/mass/inertia_about.hpp"

namespace carom {

namespace {

std::string named(const char* body, const char* member) {
  return std::string(body) + "." + member;
}

// The inverse of an inertia tensor, exactly symmetric, or a refusal.
Matrix3 inverseOfInertia(const Matrix3& inertia) {
  requireInertia(inertia);
  const Matrix3 inverse = PositiveSolve(inertia).inverse();
  if (!inverse.allFinite()) reject("inertia", toText(inertia), "is too small to be inverted");
  return inverse;
}

// A number divided by something tiny may leave the doubles.
Real inverseOf(Real value, const char* name) {
  requirePositive(value, name);
  const Real inverse = 1 / value;
  if (!std::isfinite(inverse)) reject(name, toText(value), "is too small to be inverted");
  return inverse;
}

void requireUnit(Real squaredLength, const std::string& text) {
  if (!(std::abs(squaredLength - 1) <= 2 * kUnitTolerance)) {
    reject("contact.normal", text, "must have length one");
  }
}

std::string text(const Vector2& v) {
  return "(" + toText(v.x()) + ", " + toText(v.y()) + ")";
}

void requireFinitePlanar(const Vector2& v, const std::string& name) {
  if (!v.allFinite()) reject(name, text(v), "must be finite");
}

}  // namespace

BodyMass bodyMass(const MassProperties& body, const Matrix3& R_WB) {
  requireFinite(R_WB, "R_WB");
  BodyMass result;
  result.inverseMass = inverseOf(body.mass, "mass");
  result.inverseInertia = rotateInertia(inverseOfInertia(body.inertia), R_WB);
  return result;
}

BodyMass massInWorld(const OrientedBody& body) {
  return {body.inverseMass, rotateInertia(body.inverseInertia, body.R_WB)};
}

OrientedBody orientedBody(const MassProperties& body, const Matrix3& R_WB,
                          const Velocity& velocity) {
  requireFinite(R_WB, "R_WB");
  requireFinite(velocity.linear, "velocity.linear");
  requireFinite(velocity.angular, "velocity.angular");
  return {inverseOf(body.mass, "mass"), inverseOfInertia(body.inertia), R_WB, velocity};
}

PlanarBodyMass planarBodyMass(Real mass, Real inertia) {
  return {inverseOf(mass, "mass"), inverseOf(inertia, "inertia")};
}

// The checks below run with every impulse: one sum that is finite exactly if all numbers are, and
// the message only when it is not.

void requireUsable(const Contact& contact) {
  const Real squaredLength = contact.normal.squaredNorm();
  const Real all = (contact.armA + contact.armB).sum() * 0 + squaredLength;
  if (std::abs(all - 1) <= 2 * kUnitTolerance) return;
  requireFinite(contact.normal, "contact.normal");
  requireFinite(contact.armA, "contact.armA");
  requireFinite(contact.armB, "contact.armB");
  requireUnit(squaredLength, toText(contact.normal));
}

void requireUsable(const PlanarContact& contact) {
  const Real squaredLength = contact.normal.squaredNorm();
  const Real all = (contact.armA + contact.armB).sum() * 0 + squaredLength;
  if (std::abs(all - 1) <= 2 * kUnitTolerance) return;
  requireFinitePlanar(contact.normal, "contact.normal");
  requireFinitePlanar(contact.armA, "contact.armA");
  requireFinitePlanar(contact.armB, "contact.armB");
  requireUnit(squaredLength, text(contact.normal));
}

void requireUsable(const MovingBody& body, const char* name) {
  // A number times zero is zero, unless it is infinite or not a number.
  const auto& [mass, velocity] = body;
  const Real all = (mass.inverseInertia.sum() + velocity.linear.sum() + velocity.angular.sum()) * 0;
  if (all == 0 && mass.inverseMass >= 0 && mass.inverseMass * 0 == 0) return;
  requireNonNegative(mass.inverseMass, named(name, "mass.inverseMass").c_str());
  requireFinite(mass.inverseInertia, named(name, "mass.inverseInertia").c_str());
  requireFinite(velocity.linear, named(name, "velocity.linear").c_str());
  requireFinite(velocity.angular, named(name, "velocity.angular").c_str());
}

void requireUsable(const PlanarBody& body, const char* name) {
  const auto& [mass, velocity] = body;
  const Real all =
      (velocity.linear.sum() + velocity.angular + mass.inverseMass + mass.inverseInertia) * 0;
  if (all == 0 && mass.inverseMass >= 0 && mass.inverseInertia >= 0) return;
  requireNonNegative(mass.inverseMass, named(name, "mass.inverseMass").c_str());
  requireNonNegative(mass.inverseInertia, named(name, "mass.inverseInertia").c_str());
  requireFinitePlanar(velocity.linear, named(name, "velocity.linear"));
  requireFinite(velocity.angular, named(name, "velocity.angular").c_str());
}

void requireInertia(const Matrix3& inertia) {
  requireFinite(inertia, "inertia");
  const Real largest = inertia.cwiseAbs().maxCoeff();
  if ((inertia - inertia.transpose()).cwiseAbs().maxCoeff() > kSymmetryTolerance * largest) {
    reject("inertia", toText(inertia), "must be symmetric");
  }
  if (!PositiveSolve(inertia).positive()) {
    reject("inertia", toText(inertia), "must be positive definite");
  }
}

void requireRestitution(Real restitution) {
  if (!(restitution >= 0 && restitution <= 1)) {
    reject("restitution", toText(restitution), "must be from 0 to 1");
  }
}

}  // namespace carom
