#pragma once
// How a row of the measurement crosses the pipe.

#include "grading/wire.hpp"
#include "sweep_factors.hpp"

namespace carom::grading {

template <>
struct Fields<SweepFactor> {
  static constexpr auto list =
      fieldList("boxes", &SweepFactor::boxes, "factor", &SweepFactor::factor);
};

}  // namespace carom::grading
