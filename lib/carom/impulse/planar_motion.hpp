#pragma once
// Cross products in the plane.
//
// In the plane an angular velocity and a torque have one component, along z. What is left of the
// three-dimensional cross product is a number for two vectors, and a quarter turn for a rate and an
// arm.
// Not handled: anything outside of the plane.

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"

namespace carom {

/// The z component of a x b: positive if b lies counter-clockwise of a.
/// \param a first factor [any unit] \param b second factor [any unit]
/// \return a.x b.y - a.y b.x [product of the units]
/// \ingroup impulse
inline Real planarCross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The velocity of a point of a planar body: that of its centre, plus the angular velocity times
/// the arm turned by a quarter counter-clockwise.
/// \param body how the body moves
/// \param arm from its centre of mass to the point [m, world]
/// \return velocity of the point [m/s, world]
/// \ingroup impulse
inline Vector2 planarPointVelocity(const PlanarVelocity& body, const Vector2& arm) {
  return {body.linear.x() - body.angular * arm.y(), body.linear.y() + body.angular * arm.x()};
}

}  // namespace carom
