// Exercise 06.semi_implicit_euler: what does it change to use the new velocity at once?
// Check it with: ./course check 06.semi_implicit_euler

#include "carom/motion/semi_implicit_euler.hpp"

#include "carom/core/todo.hpp"

namespace carom {

State semiImplicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  // Given: numbers that cannot be worked with are refused.
  requireUsable(state, time, dt);
  // Two lines as in explicitEuler, but for one word. Name the type of what you compute:
  // `const Coordinates velocity = ...`, and not `auto`.
  return todo<State>("semiImplicitEuler");
}

}  // namespace carom
