#pragma once
// What friction does a contact give that is solved by rows?
//
// Method: a visit to a contact asks for the impulse that stops the slip, adds it to the sum so far,
// and limits the sum: its length may be at most mu times the normal impulse. That is a cone over
// the contact. A row for each of two directions, each limited by itself, is cheaper to write and
// is a pyramid: along its corners friction is 1.41 times too strong, and it does not point against
// the slip.
// Why the sum: as with normal impulses, what a visit gave too much must be taken back.
// Source: Coulomb 1785; pyramid and cone: Stewart and Trinkle 1996.
// Not handled: the coupling of both directions with each other (solve_patches.hpp).

#include "carom/core/real.hpp"

namespace carom {

/// Friction of a contact after a visit.
/// \param friction the sum so far, along two directions at right angles [N s]
/// \param slip what is to be stopped, along the same directions [m/s]
/// \param mass effective, the same in both directions; zero or positive [kg]
/// \param limit the coefficient times the normal impulse, zero or positive [N s]
/// \return the new sum, within the cone [N s]
/// \throws InvalidInput if mass or limit is negative or not finite
/// \ingroup solver
Vector2 frictionPyramidToCone(const Vector2& friction, const Vector2& slip, Real mass, Real limit);

}  // namespace carom
