#pragma once
// How a row of the table crosses the pipe.

#include "grading/wire.hpp"
#include "tangent_rows.hpp"

namespace carom::grading {

template <>
struct Fields<TangentRow> {
  static constexpr auto list = fieldList("x", &TangentRow::x, "y", &TangentRow::y);
};

}  // namespace carom::grading
