// Exercise 05.stopping_errors: measure where a sliding crate stops, with steps of any length.
// Check it with: ./course check 05.stopping_errors

#include "stopping_errors.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"
#include "carom/impulse/friction_impulse.hpp"

namespace carom {

std::vector<StoppingError> stoppingErrors(Real speed, Real friction, std::span<const Real> steps) {
  // Given: what cannot be measured is refused.
  requirePositive(speed, "speed");
  requirePositive(friction, "friction");
  for (const Real h : steps) requirePositive(h, "step");
  std::vector<StoppingError> table;
  // For a crate of 1 kg the floor presses with kFloorGravity * h newton seconds in a step of h, and
  // an impulse of 1 N s changes its velocity by 1 m/s.
  return todo<std::vector<StoppingError>>("stoppingErrors");
}

}  // namespace carom
