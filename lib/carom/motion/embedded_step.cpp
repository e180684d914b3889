#include "carom/motion/embedded_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"
#include "carom/motion/embedded_pairs.hpp"

namespace carom {

EmbeddedStep embeddedStep(const State& state, Real time, Real dt,
                          const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  constexpr std::size_t kStages = 7;
  std::array<State, kStages> slopes;
  State at = state;
  for (std::size_t i = 0; i < kStages; ++i) {
    at = state;
    for (std::size_t j = 0; j < i; ++j) {
      const Real weight = dt * kDormandPrince5.stages[i][j];
      if (weight == 0) continue;
      at.position += weight * slopes[j].position;
      at.velocity += weight * slopes[j].velocity;
    }
    slopes[i] = {at.velocity, accelerationAt(acceleration, time + kDormandPrince5.nodes[i] * dt,
                                             at.position, at.velocity)};
  }
  State error = {Coordinates::Zero(state.position.size()),
                 Coordinates::Zero(state.velocity.size())};
  for (std::size_t i = 0; i < kStages; ++i) {
    error.position += dt * kDormandPrince5.error[i] * slopes[i].position;
    error.velocity += dt * kDormandPrince5.error[i] * slopes[i].velocity;
  }
  return {at, error};
}

Real errorRatio(const State& before, const EmbeddedStep& step, Real absolute, Real relative) {
  requirePositive(absolute, "absolute");
  requireNonNegative(relative, "relative");
  Real sum = 0;
  const auto add = [&](const Coordinates& y0, const Coordinates& y1, const Coordinates& error) {
    for (Eigen::Index i = 0; i < error.size(); ++i) {
      const Real size = std::max(std::abs(y0[i]), std::abs(y1[i]));
      const Real share = error[i] / (absolute + relative * size);
      sum += share * share;
    }
  };
  add(before.position, step.end.position, step.error.position);
  add(before.velocity, step.end.velocity, step.error.velocity);
  const Eigen::Index count = 2 * before.position.size();
  const Real ratio = count == 0 ? 0 : std::sqrt(sum / Real(count));
  return std::isnan(ratio) ? std::numeric_limits<Real>::infinity() : ratio;
}

}  // namespace carom
