#pragma once
// How the types of chapter 7 that hold numbers cross the pipe.

#include "carom/precision/cell_position.hpp"
#include "carom/precision/filtered_sign.hpp"
#include "carom/precision/stable_quadratic.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
inline std::string show(const RootCount& count) {
  switch (count) {
    case RootCount::none:
      return "none";
    case RootCount::one:
      return "one";
    case RootCount::two:
      return "two";
    case RootCount::all:
      break;
  }
  return "all";
}

template <>
struct Fields<QuadraticRoots> {
  static constexpr auto list = fieldList("count", &QuadraticRoots::count, "first",
                                         &QuadraticRoots::first, "second", &QuadraticRoots::second);
};

template <>
struct Fields<FilteredSign> {
  static constexpr auto list =
      fieldList("sign", &FilteredSign::sign, "filtered", &FilteredSign::filtered);
};

template <>
struct Fields<CellPosition> {
  static constexpr auto list =
      fieldList("cell", &CellPosition::cell, "offset", &CellPosition::offset);
};

}  // namespace carom::grading
