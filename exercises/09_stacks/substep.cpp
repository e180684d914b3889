// Exercise 09.substep: one step in equal parts
// Check it with: ./course check 09.substep

#include "carom/solver/substep.hpp"

#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"
#include "carom/solver/soft_sweep.hpp"

namespace carom {

void substep(std::span<MovingBody> bodies, std::span<ContactRow> rows, std::span<Velocity> moved,
             const SubstepPlan& plan) {
  requirePositive(plan.dt, "dt");
  if (plan.count < 1) reject("count", std::to_string(plan.count), "must be positive");
  if (moved.size() != bodies.size()) {
    reject("moved", std::to_string(moved.size()) + " entries", "must have one for each body");
  }
  // Length of a part: plan.dt / plan.count. moved[i] has .linear and .angular, as body.velocity has.
  // softSweep(bodies, rows, plan.soft, h) visits all rows once; with SoftContact{} it is rigid.
  return todo<void>("substep");
}

}  // namespace carom
