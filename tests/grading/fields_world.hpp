#pragma once
// How the types of chapter 8's world cross the pipe.

#include "carom/world/may_sleep.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
struct Fields<world::RestWatch> {
  static constexpr auto list =
      fieldList("firstWay", &world::RestWatch::firstWay, "secondWay", &world::RestWatch::secondWay,
                "speed", &world::RestWatch::speed);
};

template <>
struct Fields<world::RestLimits> {
  static constexpr auto list =
      fieldList("speed", &world::RestLimits::speed, "distance", &world::RestLimits::distance,
                "noise", &world::RestLimits::noise);
};

}  // namespace carom::grading
