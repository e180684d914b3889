#pragma once
// The direction of an axis that somebody gave us.
//
// Axes come from users, so they are checked and brought to length 1 here, once, for every function
// that takes an axis. The zero vector has no direction; there is no good answer to invent for it.

#include "carom/core/real.hpp"

namespace carom {

/// The vector of length 1 in the direction of an axis, however long or short the axis is.
/// \param axis [any unit and frame]; not zero
/// \param name what it is called, for the message
/// \return axis / |axis| [1, same frame]
/// \throws InvalidInput if the axis is zero or not finite
/// \ingroup rotation
Vector3 unitAxis(const Vector3& axis, const char* name);

}  // namespace carom
