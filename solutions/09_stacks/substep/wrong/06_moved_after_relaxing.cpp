#include "carom/solver/substep.hpp"

#include <string>

#include "carom/core/checks.hpp"
#include "carom/solver/soft_sweep.hpp"

namespace carom {

void substep(std::span<MovingBody> bodies, std::span<ContactRow> rows, std::span<Velocity> moved,
             const SubstepPlan& plan) {
  requirePositive(plan.dt, "dt");
  if (plan.count < 1) reject("count", std::to_string(plan.count), "must be positive");
  if (moved.size() != bodies.size()) {
    reject("moved", std::to_string(moved.size()) + " entries", "must have one for each body");
  }
  const Real h = plan.dt / plan.count;
  for (int n = 0; n < plan.count; ++n) {
    for (MovingBody& body : bodies) {
      if (body.mass.inverseMass > 0) body.velocity.linear += h * plan.gravity;
    }
    for (const ContactRow& row : rows) pushRow(row, row.impulse, bodies);
    softSweep(bodies, rows, plan.soft, h);
    softSweep(bodies, rows, SoftContact{}, h);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      moved[i].linear += h * bodies[i].velocity.linear;
      moved[i].angular += h * bodies[i].velocity.angular;
    }
    for (ContactRow& row : rows) row.separation += h * partingSpeed(row, bodies);
  }
}

}  // namespace carom
