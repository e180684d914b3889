// As a loop over four looks, with a table of their places and weights.
#include "carom/motion/rk4.hpp"

namespace carom {

State rk4(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  const Real place[] = {0, 0.5, 0.5, 1}, weight[] = {1, 2, 2, 1};
  State k = {Coordinates::Zero(state.position.size()), Coordinates::Zero(state.velocity.size())};
  State end = state;
  for (int i = 0; i < 4; ++i) {
    const Real h = place[i] * dt;
    const State at = {state.position + h * k.position, state.velocity + h * k.velocity};
    k = {at.velocity, accelerationAt(acceleration, time + h, at.position, at.velocity)};
    end.position += dt / 6 * weight[i] * k.position;
    end.velocity += dt / 6 * weight[i] * k.velocity;
  }
  return end;
}

}  // namespace carom
