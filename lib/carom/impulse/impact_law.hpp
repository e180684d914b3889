#pragma once
// What two materials say about an impact, and what an impact law answers.
//
// Not handled: coefficients that depend on speed, and the duration of an impact.

#include "carom/core/real.hpp"

namespace carom {

/// The material of a pair. \ingroup impulse
struct ImpactLaw {
  Real restitution = 0;  ///< e, from 0 (no bounce) to 1 (no loss) [1]
  Real friction = 0;     ///< mu, zero or positive [1]
  /// From -1 (the slip is left alone) through 0 (a contact that sticks comes to rest) to 1 (its
  /// slip is turned round: a super ball); used by passiveImpact() only [1]
  Real tangentialRestitution = 0;
};

/// What the two points did. \ingroup impulse
enum class ContactMotion {
  none,    ///< they did not approach, or neither body can be moved: no impulse
  slides,  ///< friction was at its limit, mu times the normal impulse
  sticks   ///< friction was enough for what sticking takes
};

/// An impulse with friction. \ingroup impulse
struct Impact {
  Vector3 impulse = Vector3::Zero();           ///< on B; A gets the opposite [N s, world]
  ContactMotion motion = ContactMotion::none;  ///< what the points did
};

/// An impulse with friction in the plane. \ingroup impulse
struct PlanarImpact {
  Vector2 impulse = Vector2::Zero();           ///< on B; A gets the opposite [N s, world]
  ContactMotion motion = ContactMotion::none;  ///< what the points did
};

/// Refuses coefficients that would take energy from nowhere.
/// \param law any coefficients
/// \throws InvalidInput if restitution is not from 0 to 1, friction negative or not finite, or
/// tangential restitution not from -1 to 1
/// \ingroup impulse
void requireUsable(const ImpactLaw& law);

}  // namespace carom
