#pragma once
// What do chosen steps cost when the number of coordinates is known to the compiler?
//
// The pairs and the control of trajectory.hpp, without what it keeps for the times between, for
// y' = f(t, y) with a y of fixed size. Sums over slopes are written out by the compiler, without the
// terms that are zero, and nothing is asked of the system: about ten times faster for a few
// coordinates. A test holds it to Trajectory, bit for bit.
// Not handled: values between the steps.

#include <array>
#include <tuple>
#include <utility>

#include "carom/motion/adaptive.hpp"
#include "carom/motion/embedded_pairs.hpp"
#include "carom/motion/step_control.hpp"

namespace carom {

/// Where a run with chosen steps came to. \tparam n how many numbers \ingroup motion
template <int n>
struct FixedRun {
  Eigen::Matrix<Real, n, 1> y;                          ///< the numbers at `time`
  Real time = 0;                                        ///< how far it came [s]
  AdaptiveStatus status = AdaptiveStatus::kReachedEnd;  ///< why it stopped
  int accepted = 0;                                     ///< steps made
  int rejected = 0;                                     ///< steps tried and thrown away
};

/// What fixedPair() is made of. \ingroup motion
namespace fixed_pair {

/// The weights of the error, which are no stage. \ingroup motion
inline constexpr int kError = -1;
/// The weights of the second error, of the lower order. \ingroup motion
inline constexpr int kLowError = -2;

/// A weight of a pair.
/// \tparam method the pair
/// \tparam row a stage, kError or kLowError
/// \param j which slope
/// \return its weight [1]
/// \ingroup motion
template <const auto& method, int row>
constexpr Real weightOf(std::size_t j) {
  if constexpr (row == kError) return method.error[j];
  if constexpr (row == kLowError) return method.lowError[j];
  if constexpr (row >= 0) return method.stages[static_cast<std::size_t>(row)][j];
}

/// The sum of weights times slopes, written out.
/// \tparam method the pair
/// \tparam row a stage, kError or kLowError
/// \tparam V a vector of fixed size
/// \tparam count how many slopes there are
/// \tparam j which of them count
/// \param slopes of the stages
/// \param which the numbers j
/// \return the sum
/// \ingroup motion
template <const auto& method, int row, class V, std::size_t count, std::size_t... j>
[[gnu::always_inline]] inline V weighted(const std::array<V, count>& slopes,
                                         [[maybe_unused]] std::index_sequence<j...> which) {
  V sum = V::Zero();
  const auto add = [&]<std::size_t i>() __attribute__((always_inline)) {
    constexpr Real weight = weightOf<method, row>(i);
    if constexpr (weight != 0) sum += weight * slopes[i];
  };
  (add.template operator()<j>(), ...);
  return sum;
}

}  // namespace fixed_pair

/// Follows y' = f(t, y) from one time to another with chosen steps.
/// \tparam method the pair, for example kDormandPrince8
/// \tparam n how many numbers
/// \tparam Flow called as flow(time, y), answers a column of n numbers
/// \param y at the start
/// \param time at the start [s]
/// \param end when to stop; earlier than `time` runs backwards [s]
/// \param tolerance what error is allowed per step
/// \param flow f
/// \return the numbers at the end, or where and why it stopped before
/// \throws InvalidInput if the tolerance is impossible
/// \ingroup motion
template <const auto& method, int n, class Flow>
FixedRun<n> fixedPair(const Eigen::Matrix<Real, n, 1>& y, Real time, Real end,
                      const Tolerance& tolerance, Flow&& flow) {
  using V = Eigen::Matrix<Real, n, 1>;
  requireUsable(tolerance);
  constexpr std::size_t kStages = std::tuple_size_v<decltype(method.error)>;
  std::array<V, kStages> slopes;
  FixedRun<n> run;
  run.y = y;
  run.time = time;
  detail::StepControl control(time, end, tolerance.maxSteps, method.order);

  V next = y;
  const auto look = [&]<std::size_t i>() __attribute__((always_inline)) {
    if constexpr (i > 0) {
      constexpr int row = static_cast<int>(i);
      next = run.y + control.dt() *
                         fixed_pair::weighted<method, row>(slopes, std::make_index_sequence<i>());
    }
    slopes[i] = flow(run.time + method.nodes[i] * control.dt(), next);
  };
  look.template operator()<0>();
  while (control.goesOn(run)) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (look.template operator()<i + 1>(), ...);
    }
    (std::make_index_sequence<kStages - 1>());

    const auto all = std::make_index_sequence<kStages>();
    const Real dt = control.dt();
    const V off = dt * fixed_pair::weighted<method, fixed_pair::kError>(slopes, all);
    const V lowOff = dt * fixed_pair::weighted<method, fixed_pair::kLowError>(slopes, all);
    const Real ratio = detail::ratioOf(detail::meanSquare(off, run.y, next, tolerance),
                                       detail::meanSquare(lowOff, run.y, next, tolerance));
    if (control.rejects(run, ratio)) continue;
    control.advance(run, ratio);
    run.y = next;
    slopes[0] = slopes[kStages - 1];
  }
  return run;
}

}  // namespace carom
