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
  int left = plan.count;
  const Real h = plan.dt / left;
  while (left-- > 0) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const bool falls = bodies[i].mass.inverseMass != 0;
      bodies[i].velocity.linear += (falls ? h : 0) * plan.gravity;
    }
    for (std::size_t k = 0; k < rows.size(); ++k) pushRow(rows[k], rows[k].impulse, bodies);
    softSweep(bodies, rows, plan.soft, h);
    for (ContactRow& row : rows) row.separation += partingSpeed(row, bodies) * h;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      moved[i].angular += bodies[i].velocity.angular * h;
      moved[i].linear += bodies[i].velocity.linear * h;
    }
    softSweep(bodies, rows, {}, h);
  }
}

}  // namespace carom
