#pragma once
// How the table of 01.turning_errors crosses the pipe.

#include "grading/fields_rotation.hpp"
#include "turning_errors.hpp"

namespace carom::grading {

template <>
struct Fields<TurningError> {
  static constexpr auto list = fieldList("steps", &TurningError::steps, "dt", &TurningError::dt,
                                         "error", &TurningError::error);
};

}  // namespace carom::grading
