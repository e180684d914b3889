#pragma once
// The equations of one contact, sorted into normal and tangential.
//
// Along the normal and two tangents the change of the relative velocity is
//   normal      kn jn + kn c . jt
//   tangential  kn c jn + (S + kn c c^T) jt.
// Both impact laws fix the normal velocity after the impact first. That ties the normal impulse to
// the friction, jn = j0 - c . jt, and leaves two equations for the friction alone: its matrix is S,
// the Schur complement of kn in K.
// Why not invert K: where K is badly conditioned the normal velocity of the solution would be off
// by as much. So it is right by construction.
// Source: the tangents are those of Duff and others 2017, without a branch.
// Not handled: bodies that can only turn about a fixed axis give a singular S; solvePositive() then
// leaves out what cannot move. This header is for the library.

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/impact_law.hpp"

namespace carom {

/// A contact of two bodies in its own axes. \ingroup impulse
struct ContactEquations {
  Vector3 normal = Vector3::UnitZ();     ///< unit, from A to B [1, world]
  Vector3 tangent1 = Vector3::UnitX();   ///< unit [1, world]
  Vector3 tangent2 = Vector3::UnitY();   ///< unit, right-handed with the others [1, world]
  Real parting = 0;                      ///< u . n; negative: the points approach [m/s]
  Vector2 slip = Vector2::Zero();        ///< u along the tangents [m/s]
  Real inverseMass = 0;                  ///< kn, along the normal [1/kg]
  Vector2 coupling = Vector2::Zero();    ///< c: normal impulse that friction takes over [1]
  Matrix2 tangential = Matrix2::Zero();  ///< S [1/kg]

  /// An impulse in world axes. \param normalImpulse [N s] \param tangentialImpulse [N s]
  /// \return the impulse on B [N s, world]
  Vector3 inWorld(Real normalImpulse, const Vector2& tangentialImpulse) const {
    return normalImpulse * normal + tangentialImpulse.x() * tangent1 +
           tangentialImpulse.y() * tangent2;
  }
};

/// Solves S x = b for a symmetric S that is positive, or nearly zero in a direction, which then is
/// left out of the solution. \param S matrix [any unit] \param b right side \return x
/// \ingroup impulse
inline Vector2 solvePositive(const Matrix2& S, const Vector2& b) {
  // Below this share of the larger diagonal entry the rest of an elimination is rounding.
  constexpr Real kNothing = 1e-15;
  const int first = S(0, 0) >= S(1, 1) ? 0 : 1;
  const int second = 1 - first;
  const Real pivot = S(first, first);
  if (!(pivot > 0)) return Vector2::Zero();
  const Real factor = S(1, 0) / pivot;
  const Real rest = S(second, second) - factor * S(1, 0);
  Vector2 x;
  x(second) = rest > kNothing * pivot ? (b(second) - factor * b(first)) / rest : 0;
  x(first) = b(first) / pivot - factor * x(second);
  return x;
}

/// Sets up the equations of a contact.
/// \param a body A \param b body B \param contact where they touch, usable
/// \return matrix and velocities along normal and tangents
/// \ingroup impulse
inline ContactEquations contactEquations(const MovingBody& a, const MovingBody& b,
                                         const Contact& contact) {
  ContactEquations eq;
  const Vector3& n = contact.normal;
  const Real sign = std::copysign(1.0, n.z());
  const Real p = -1 / (sign + n.z()), q = n.x() * n.y() * p;
  eq.normal = n;
  eq.tangent1 = {1 + sign * n.x() * n.x() * p, sign * q, -sign * n.x()};
  eq.tangent2 = {q, sign + n.y() * n.y() * p, -n.y()};

  const Vector3 u = relativeVelocity(a, b, contact);
  eq.parting = u.dot(n);
  eq.slip = {u.dot(eq.tangent1), u.dot(eq.tangent2)};

  // K between the axes: what impulses along one change along another.
  const Real masses = a.mass.inverseMass + b.mass.inverseMass;
  const Vector3 &t1 = eq.tangent1, &t2 = eq.tangent2;
  const Vector3 nA = cross(contact.armA, n), nB = cross(contact.armB, n);
  const Vector3 sA = cross(contact.armA, t1), sB = cross(contact.armB, t1);
  const Vector3 tA = cross(contact.armA, t2), tB = cross(contact.armB, t2);
  const Vector3 byNormalA = a.mass.inverseInertia * nA, byNormalB = b.mass.inverseInertia * nB;
  const Vector3 by1A = a.mass.inverseInertia * sA, by1B = b.mass.inverseInertia * sB;
  const Vector3 by2A = a.mass.inverseInertia * tA, by2B = b.mass.inverseInertia * tB;
  eq.inverseMass = masses + nA.dot(byNormalA) + nB.dot(byNormalB);
  if (!(eq.inverseMass > 0)) return eq;
  const Vector2 across(sA.dot(byNormalA) + sB.dot(byNormalB),
                       tA.dot(byNormalA) + tB.dot(byNormalB));
  eq.coupling = across / eq.inverseMass;
  const Real k12 = sA.dot(by2A) + sB.dot(by2B) - eq.coupling.x() * across.y();
  eq.tangential(0, 0) = masses + sA.dot(by1A) + sB.dot(by1B) - eq.coupling.x() * across.x();
  eq.tangential(1, 1) = masses + tA.dot(by2A) + tB.dot(by2B) - eq.coupling.y() * across.y();
  eq.tangential(0, 1) = eq.tangential(1, 0) = k12;
  return eq;
}

/// A contact of two planar bodies in its own axes; the tangent is the normal turned clockwise.
/// \ingroup impulse
struct PlanarContactEquations {
  Vector2 normal = Vector2::UnitY();   ///< unit, from A to B [1, world]
  Vector2 tangent = Vector2::UnitX();  ///< unit [1, world]
  Real parting = 0;                    ///< u . n; negative: the points approach [m/s]
  Real slip = 0;                       ///< u along the tangent [m/s]
  Real inverseMass = 0;                ///< kn, along the normal [1/kg]
  Real coupling = 0;                   ///< c: normal impulse that friction takes over [1]
  Real tangential = 0;                 ///< S [1/kg]

  /// An impulse in world axes. \param normalImpulse [N s] \param tangentialImpulse [N s]
  /// \return the impulse on B [N s, world]
  Vector2 inWorld(Real normalImpulse, Real tangentialImpulse) const {
    return normalImpulse * normal + tangentialImpulse * tangent;
  }
};

/// Sets up the equations of a planar contact.
/// \param a body A \param b body B \param contact where they touch, usable
/// \return matrix and velocities along normal and tangent
/// \ingroup impulse
inline PlanarContactEquations contactEquations(const PlanarBody& a, const PlanarBody& b,
                                               const PlanarContact& contact) {
  PlanarContactEquations eq;
  eq.normal = contact.normal;
  eq.tangent = {contact.normal.y(), -contact.normal.x()};
  const Vector2 u = relativeVelocity(a, b, contact);
  eq.parting = u.dot(eq.normal);
  eq.slip = u.dot(eq.tangent);

  const Real masses = a.mass.inverseMass + b.mass.inverseMass;
  const Real IA = a.mass.inverseInertia, IB = b.mass.inverseInertia;
  const Real nA = planarCross(contact.armA, eq.normal), nB = planarCross(contact.armB, eq.normal);
  const Real tA = planarCross(contact.armA, eq.tangent), tB = planarCross(contact.armB, eq.tangent);
  eq.inverseMass = masses + IA * nA * nA + IB * nB * nB;
  if (!(eq.inverseMass > 0)) return eq;
  const Real across = IA * nA * tA + IB * nB * tB;
  eq.coupling = across / eq.inverseMass;
  eq.tangential = masses + IA * tA * tA + IB * tB * tB - eq.coupling * across;
  return eq;
}

/// contactEquations() of what an impact law is given, looked at first.
/// \tparam Body MovingBody or PlanarBody \tparam AnyContact Contact or PlanarContact
/// \param a body A \param b body B \param contact where they touch \param law the material
/// \return matrix and velocities along normal and tangents
/// \throws InvalidInput if a body, the contact or the law is not usable
/// \ingroup impulse
template <class Body, class AnyContact>
auto checkedEquations(const Body& a, const Body& b, const AnyContact& contact,
                      const ImpactLaw& law) {
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireUsable(contact);
  requireUsable(law);
  return contactEquations(a, b, contact);
}

}  // namespace carom
