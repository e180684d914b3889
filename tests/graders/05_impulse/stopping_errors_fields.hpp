#pragma once
// How a row of the measurement crosses the pipe.

#include "grading/wire.hpp"
#include "stopping_errors.hpp"

namespace carom::grading {

template <>
struct Fields<StoppingError> {
  static constexpr auto list = fieldList("step", &StoppingError::step, "distance",
                                         &StoppingError::distance, "error", &StoppingError::error);
};

}  // namespace carom::grading
