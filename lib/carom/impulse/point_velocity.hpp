#pragma once
// How fast does a point of a body move that flies and turns?
//
// Method: v + omega x r. The body's centre carries every point along; turning adds a velocity that
// is perpendicular to the axis and to the arm, and grows with the distance from the axis.
// Why this order: r x omega is the same vector backwards, and the unit does not warn.
// Source: equations 37 and 38.
// Not handled: bodies that bend; every point of a rigid body has the same angular velocity.

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"

namespace carom {

/// The velocity of one point of a rigid body.
/// \param body how the body moves [world]
/// \param arm from its centre of mass to the point [m, world]
/// \return velocity of the point [m/s, world]
/// \source{37,38}
/// \erratum{6.9}
/// \ingroup impulse
Vector3 pointVelocity(const Velocity& body, const Vector3& arm);

}  // namespace carom
