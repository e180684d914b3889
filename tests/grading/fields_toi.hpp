#pragma once
// How the types of chapter 7 that move cross the pipe, and how a status is worded in a message.

#include <string>

#include "carom/toi/moving_ball.hpp"
#include "carom/toi/sweep.hpp"
#include "carom/toi/time_of_impact.hpp"
#include "grading/fields_detection.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
inline std::string show(const ImpactStatus& status) {
  switch (status) {
    case ImpactStatus::kHit:
      return "kHit";
    case ImpactStatus::kNoHit:
      return "kNoHit";
    case ImpactStatus::kOverlapping:
      return "kOverlapping";
    case ImpactStatus::kLimit:
      return "kLimit";
  }
  return "no status";
}

template <>
struct Fields<TimeOfImpact> {
  static constexpr auto list = fieldList(
      "status", &TimeOfImpact::status, "time", &TimeOfImpact::time, "point", &TimeOfImpact::point,
      "normal", &TimeOfImpact::normal, "gap", &TimeOfImpact::gap, "steps", &TimeOfImpact::steps);
};

template <>
struct Fields<MovingBall> {
  static constexpr auto list = fieldList("radius", &MovingBall::radius, "centre",
                                         &MovingBall::centre, "velocity", &MovingBall::velocity);
};

template <>
struct Fields<HalfSpace> {
  static constexpr auto list =
      fieldList("normal", &HalfSpace::normal, "offset", &HalfSpace::offset);
};

template <>
struct Fields<Sweep> {
  static constexpr auto list = fieldList("start", &Sweep::start, "velocity", &Sweep::velocity,
                                         "angularVelocity", &Sweep::angularVelocity, "acceleration",
                                         &Sweep::acceleration, "centre", &Sweep::centre);
};

}  // namespace carom::grading
