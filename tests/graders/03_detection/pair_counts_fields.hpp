#pragma once
// How a row of the table crosses the pipe.

#include "grading/fields_detection.hpp"
#include "pair_counts.hpp"

namespace carom::grading {

template <>
struct Fields<PairCount> {
  static constexpr auto list = fieldList("boxes", &PairCount::boxes, "asked", &PairCount::asked,
                                         "kept", &PairCount::kept);
};

}  // namespace carom::grading
