#pragma once
// How the types of chapter 6 cross the pipe.

#include "carom/motion/adaptive.hpp"
#include "carom/motion/exact_rotor.hpp"
#include "carom/motion/measure_order.hpp"
#include "carom/motion/pair_forces.hpp"
#include "carom/motion/verlet.hpp"
#include "grading/fields_rotation.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

// How many coordinates there are is known only when the program runs, so they cross as a list.
template <>
inline void Writer::put(const Coordinates& x) {
  put(std::vector<Real>(x.data(), x.data() + x.size()));
}

template <>
inline void Reader::get(Coordinates& x) {
  const auto numbers = take<std::vector<Real>>();
  x = Eigen::Map<const Coordinates>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

template <>
inline void flatten(const Coordinates& x, std::vector<double>& out) {
  flatten(std::vector<Real>(x.data(), x.data() + x.size()), out);
}

template <class R>
R lazyValue(bool one);
template <>
inline Coordinates lazyValue<Coordinates>(bool) {
  return {};
}

template <>
struct Fields<State> {
  static constexpr auto list =
      fieldList("position", &State::position, "velocity", &State::velocity);
};

template <>
struct Fields<TwoPositions> {
  static constexpr auto list =
      fieldList("previous", &TwoPositions::previous, "current", &TwoPositions::current);
};

template <>
struct Fields<StepError> {
  static constexpr auto list = fieldList("dt", &StepError::dt, "error", &StepError::error);
};

template <>
struct Fields<StepTry> {
  static constexpr auto list =
      fieldList("length", &StepTry::length, "left", &StepTry::left, "duration", &StepTry::duration,
                "error", &StepTry::error, "tolerance", &StepTry::tolerance, "order",
                &StepTry::order, "refusedBefore", &StepTry::refusedBefore);
};

template <>
struct Fields<StepChoice> {
  static constexpr auto list = fieldList("accepted", &StepChoice::accepted, "wanted",
                                         &StepChoice::wanted, "next", &StepChoice::next);
};

template <>
struct Fields<Tolerance> {
  static constexpr auto list = fieldList("relative", &Tolerance::relative, "absolute",
                                         &Tolerance::absolute, "maxSteps", &Tolerance::maxSteps);
};

template <>
struct Fields<AdaptiveRun> {
  static constexpr auto list = fieldList(
      "state", &AdaptiveRun::state, "time", &AdaptiveRun::time, "status", &AdaptiveRun::status,
      "accepted", &AdaptiveRun::accepted, "rejected", &AdaptiveRun::rejected);
};

template <>
struct Fields<RotorState> {
  static constexpr auto list =
      fieldList("q_WB", &RotorState::q_WB, "angularVelocity", &RotorState::angularVelocity);
};

template <>
struct Fields<RoundMoments> {
  static constexpr auto list =
      fieldList("across", &RoundMoments::across, "along", &RoundMoments::along);
};

template <>
struct Fields<LennardJones> {
  static constexpr auto list = fieldList("depth", &LennardJones::depth, "size", &LennardJones::size,
                                         "cutoff", &LennardJones::cutoff);
};

template <>
struct Fields<CrowdForces> {
  static constexpr auto list =
      fieldList("forces", &CrowdForces::forces, "energy", &CrowdForces::energy);
};

}  // namespace carom::grading
