#pragma once
// Are four sweeps over one step better, or one sweep over each of four steps?
//
// Method: a step is cut into equal parts, and in each everything is done once: gravity, the
// impulses of the part before, one sweep with soft contacts, moving, and one rigid sweep that takes
// back the speed that only pushed overlap apart (relaxation).
// Why: the error of a sweep that is not finished is a velocity, and it acts for a part of the step
// only, so its way falls with the square of the number of parts; and springs may be stiffer. The
// contacts are looked for once: in a part, only their separations go on.
// Source: Macklin and others 2019 ("Small steps in physics simulation"); Catto 2024 (Solver2D).
// Not handled: contacts that begin or turn within the step; friction.

#include <span>

#include "carom/solver/contact_row.hpp"
#include "carom/solver/soft_contact.hpp"

namespace carom {

/// How a step is cut up. \ingroup solver
struct SubstepPlan {
  Vector3 gravity = Vector3(0, 0, -9.81);  ///< [m/s^2, world]
  Real dt = 1.0 / 60;                      ///< length of the whole step, positive [s]
  int count = 4;                           ///< parts, positive
  SoftContact soft = {};                   ///< for a part
};

/// Makes a step in equal parts.
/// \param bodies their velocities are changed
/// \param rows start with the impulses of the last part of the step before; impulses and
/// separations are changed
/// \param moved one for each body: how far it moved [m] and turned [rad] is added
/// \param plan how the step is cut up
/// \throws InvalidInput if dt or count is not positive, or there is not one `moved` for each body
/// \ingroup solver
void substep(std::span<MovingBody> bodies, std::span<ContactRow> rows, std::span<Velocity> moved,
             const SubstepPlan& plan);

}  // namespace carom
