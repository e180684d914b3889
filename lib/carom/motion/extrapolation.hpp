#pragma once
// How does the plainest method become one of order twelve?
//
// Method: go over the same step with 1, 2, ..., m steps of Verlet. What they are off by is a series
// in the square of their length, and m answers are enough to take its first m - 1 terms away: a
// weighted sum of them is of order 2 m.
// Why: for eleven digits no method of these chapters asks for the force less often, and there is
// nothing to look up in a table: the weights are a product of whole numbers.
// Why not always: a sum of symplectic steps is not symplectic. The energy drifts by what the method
// is off by, so make the steps short enough that this is rounding. And the weights are larger than
// one and of both signs, so each step rounds some ten times as much.
// Source: Gragg 1965, Bulirsch and Stoer 1966; Hairer, Nørsett and Wanner, Solving Ordinary
// Differential Equations I, 1993, II.9 and II.14 (Störmer's method); Chin, Celestial Mechanics and
// Dynamical Astronomy 106, 2010 (as sums of products of exact parts, which is how tops are done).
// Not handled: forces that depend on the velocity, and a choice of the step.

#include <array>

#include "carom/core/real.hpp"

namespace carom {

/// The most answers that are put together: order 16. \ingroup motion
inline constexpr int kMostAnswers = 8;

/// The weights of the answers by 1, 2, ..., m steps.
/// \param answers m, from 1 to kMostAnswers
/// \return the product of k^2 / (k^2 - j^2) over all j but k, for k = 1 to m; they add up to one
/// \ingroup motion
constexpr std::array<Real, kMostAnswers> extrapolationWeights(int answers) {
  std::array<Real, kMostAnswers> weights = {};
  for (int k = 1; k <= answers; ++k) {
    Real above = 1, below = 1;
    for (int j = 1; j <= answers; ++j) {
      if (j == k) continue;
      above *= k * k;
      below *= k * k - j * j;
    }
    weights[static_cast<std::size_t>(k - 1)] = above / below;
  }
  return weights;
}

/// Steps positions and velocities by extrapolation, in place: order 2 m for m (m + 1) / 2 forces a
/// step. It allocates nothing that `acceleration` does not.
/// \tparam V a number or a vector of fixed size
/// \tparam Force called as acceleration(time, position), answers something that converts to V
/// \param position at the start; is changed to that at the end [m]
/// \param velocity at the start; is changed to that at the end [m/s]
/// \param time at the start [s]
/// \param dt length of a step; negative runs backwards [s]
/// \param count how many steps
/// \param answers m, from 1 to kMostAnswers
/// \param acceleration a(t, x) [m/s^2]
/// \ingroup motion
template <class V, class Force>
void extrapolatedSteps(V& position, V& velocity, Real time, Real dt, int count, int answers,
                       Force&& acceleration) {
  const std::array<Real, kMostAnswers> weights = extrapolationWeights(answers);
  for (int step = 0; step < count; ++step) {
    const Real start = time + step * dt;
    // What the step adds to the start is what is extrapolated: it is small, and so is its rounding.
    V moved = 0 * position, gained = 0 * velocity;
    for (int k = 1; k <= answers; ++k) {
      const Real h = dt / k;
      V x = h / 2 * velocity, v = 0 * velocity;
      for (int i = 0; i < k; ++i) {
        v += h * acceleration(start + (i + 0.5) * h, position + x);
        x += (i + 1 < k ? h : h / 2) * (velocity + v);
      }
      moved += weights[static_cast<std::size_t>(k - 1)] * x;
      gained += weights[static_cast<std::size_t>(k - 1)] * v;
    }
    position += moved;
    velocity += gained;
  }
}

}  // namespace carom
