#pragma once
// How a row of the table crosses the pipe.

#include "grading/fields_mass.hpp"
#include "monte_carlo_error.hpp"

namespace carom::grading {

template <>
struct Fields<DartError> {
  static constexpr auto list =
      fieldList("samples", &DartError::samples, "relativeError", &DartError::relativeError);
};

}  // namespace carom::grading
