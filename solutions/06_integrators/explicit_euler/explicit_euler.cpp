// Exercise 06.explicit_euler: where is everything a step later, if nothing changed meanwhile?
// Check it with: ./course check 06.explicit_euler

#include "carom/motion/explicit_euler.hpp"

#include "carom/core/todo.hpp"

namespace carom {

State explicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  // Given: numbers that cannot be worked with are refused.
  requireUsable(state, time, dt);
  //# solution
  const Coordinates a = accelerationAt(acceleration, time, state.position, state.velocity);
  return {state.position + dt * state.velocity, state.velocity + dt * a};
  //# stub
  // accelerationAt(acceleration, time, position, velocity) asks the forces. Columns of coordinates
  // can be added, and multiplied by a number. {position, velocity} is a State.
  //#| return todo<State>("explicitEuler");
  //# end
}

}  // namespace carom
