#include "carom/motion/yoshida.hpp"

#include "carom/motion/composition.hpp"

namespace carom {
namespace {

State composed(const State& state, Real time, Real dt, std::span<const Real> weights,
               const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  State next = state;
  composedStep(next.position, next.velocity, time, dt, weights,
               [&](Real t, const Coordinates& x) -> Coordinates {
                 return accelerationAt(acceleration, t, x, next.velocity);
               });
  return next;
}

}  // namespace

State yoshida4(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  return composed(state, time, dt, kYoshida4Weights, acceleration);
}

State yoshida6(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  return composed(state, time, dt, kYoshida6Weights, acceleration);
}

}  // namespace carom
