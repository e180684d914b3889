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

void requireUsable(const Contact& contact) {
  requireFinite(contact.normal, "contact.normal");
  requireFinite(contact.armA, "contact.armA");
  requireFinite(contact.armB, "contact.armB");
  requireUnit(contact.normal.squaredNorm(), toText(contact.normal));
}

void requireUsable(const PlanarContact& contact) {
  requireFinitePlanar(contact.normal, "contact.normal");
  requireFinitePlanar(contact.armA, "contact.armA");
  requireFinitePlanar(contact.armB, "contact.armB");
  requireUnit(contact.normal.squaredNorm(), text(contact.normal));
}

void requireUsable(const MovingBody& body, const char* name) {
  requireNonNegative(body.mass.inverseMass, named(name, "mass.inverseMass").c_str());
  requireFinite(body.mass.inverseInertia, named(name, "mass.inverseInertia").c_str());
  requireFinite(body.velocity.linear, named(name, "velocity.linear").c_str());
  requireFinite(body.velocity.angular, named(name, "velocity.angular").c_str());
}

void requireUsable(const PlanarBody& body, const char* name) {
  requireNonNegative(body.mass.inverseMass, named(name, "mass.inverseMass").c_str());
  requireNonNegative(body.mass.inverseInertia, named(name, "mass.inverseInertia").c_str());
  requireFinitePlanar(body.velocity.linear, named(name, "velocity.linear"));
  requireFinite(body.velocity.angular, named(name, "velocity.angular").c_str());
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
