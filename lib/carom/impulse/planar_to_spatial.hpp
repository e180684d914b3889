#pragma once
// A planar body is a spatial one that can neither leave the plane nor turn out of it.
//
// Its inverse inertia has one entry, about z; the others are zero, so no impulse turns it about x
// or y. Whatever works in space then works in the plane. This header is for the library and for
// programs that step a planar world.

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"

namespace carom {

/// A vector of the plane in space. \param v any vector [any unit] \return (v, 0)
/// \ingroup impulse
inline Vector3 inSpace(const Vector2& v) {
  return {v.x(), v.y(), 0};
}

/// A planar body in space. \param body the body \return the same at z = 0
/// \ingroup impulse
inline MovingBody inSpace(const PlanarBody& body) {
  MovingBody lifted;
  lifted.mass.inverseMass = body.mass.inverseMass;
  lifted.mass.inverseInertia(2, 2) = body.mass.inverseInertia;
  lifted.velocity = {inSpace(body.velocity.linear), {0, 0, body.velocity.angular}};
  return lifted;
}

/// A planar contact in space. \param contact the contact \return the same at z = 0
/// \ingroup impulse
inline Contact inSpace(const PlanarContact& contact) {
  return {inSpace(contact.normal), inSpace(contact.armA), inSpace(contact.armB)};
}

/// What of a motion lies in the plane. \param velocity any motion \return its part along x and y
/// and about z
/// \ingroup impulse
inline PlanarVelocity inPlane(const Velocity& velocity) {
  return {{velocity.linear.x(), velocity.linear.y()}, velocity.angular.z()};
}

}  // namespace carom
