#pragma once
// What do all methods that choose their steps have in common?
//
// How long the next try is, when there is none, and what becomes of it. It is the rule of
// rk_adaptive.hpp, which spells it out, as Trajectory and fixedPair() use it: they differ in where
// they keep their numbers, and in what they keep of a step.
// Source: Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, 1993, II.4; II.10
// for the two estimates.

#include <algorithm>
#include <cmath>

#include "carom/motion/adaptive.hpp"

namespace carom::detail {

/// The lengths of the steps of one run. \ingroup motion
class StepControl {
 public:
  /// Before the first step.
  /// \param time at the start [s] \param end when to stop [s]
  /// \param maxSteps tries, accepted or not, before it gives up
  /// \param order power of the step with which its error goes, positive
  StepControl(Real time, Real end, int maxSteps, int order)
      : end_(end), dt_((end - time) / 100), maxSteps_(maxSteps), order_(order) {
    // A hundredth is a guess: the first steps put it right.
  }

  /// Length of the step to try. \return dt [s]
  Real dt() const {
    return dt_;
  }

  /// Whether there is a step to try; sets its length.
  /// \tparam Run has time, status, accepted and rejected
  /// \param run so far; its status says why there is none
  /// \return false at the end, and when it gives up
  template <class Run>
  bool goesOn(Run& run) {
    if (run.time == end_) return false;
    if (run.accepted + run.rejected == maxSteps_) {
      run.status = AdaptiveStatus::kTooManySteps;
      return false;
    }
    // The last step ends on the dot, and the one before it leaves no crumb.
    last_ = std::abs(end_ - run.time) <= 1.01 * std::abs(dt_);
    if (last_) dt_ = end_ - run.time;
    if (!last_ && run.time + dt_ / 10 == run.time) {
      run.status = AdaptiveStatus::kStepTooSmall;
      return false;
    }
    return true;
  }

  /// Throws a step away if its error is too large, and shortens the next one.
  /// \tparam Run as for goesOn() \param run so far
  /// \param ratio error of the step in units of what is allowed; may be no number
  /// \return true if it is thrown away
  template <class Run>
  bool rejects(Run& run, Real ratio) {
    if (ratio <= 1) return false;
    ++run.rejected;
    dt_ *= std::isnan(ratio) ? 0.2 : stepFactor(ratio, order_);
    return true;
  }

  /// Moves on to the end of a step that was not thrown away.
  /// \tparam Run as for goesOn() \param run so far \param ratio of that step
  template <class Run>
  void advance(Run& run, Real ratio) {
    run.time = last_ ? end_ : run.time + dt_;
    ++run.accepted;
    dt_ *= stepFactor(ratio, order_);
  }

 private:
  Real end_;
  Real dt_;
  int maxSteps_;
  int order_;
  bool last_ = false;
};

/// The mean square of an error in units of what is allowed.
/// \tparam V a column \param error of each number \param before the numbers before the step
/// \param after and after it \param tolerance what is allowed
/// \return the mean of (error / allowed)^2; zero of no numbers [1]
/// \ingroup motion
template <class V>
Real meanSquare(const V& error, const V& before, const V& after, const Tolerance& tolerance) {
  Real sum = 0;
  for (Eigen::Index i = 0; i < error.size(); ++i) {
    const Real size = std::max(std::abs(before[i]), std::abs(after[i]));
    const Real share = error[i] / (tolerance.absolute + tolerance.relative * size);
    sum += share * share;
  }
  return error.size() == 0 ? 0 : sum / Real(error.size());
}

/// The error of a step from two estimates: the lower one only keeps the higher one from vanishing
/// by chance.
/// \param high mean square by the higher order, zero or positive
/// \param low by the lower order; zero where there is only one
/// \return error in units of what is allowed [1]
/// \ingroup motion
inline Real ratioOf(Real high, Real low) {
  const Real scale = high + 0.01 * low;
  return low == 0 ? std::sqrt(high) : scale == 0 ? 0 : high / std::sqrt(scale);
}

}  // namespace carom::detail
