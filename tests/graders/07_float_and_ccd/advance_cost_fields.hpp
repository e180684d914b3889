#pragma once
// How a row of the measurement crosses the pipe.

#include "advance_cost.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
struct Fields<AdvanceCost> {
  static constexpr auto list =
      fieldList("tolerance", &AdvanceCost::tolerance, "steps", &AdvanceCost::steps);
};

}  // namespace carom::grading
