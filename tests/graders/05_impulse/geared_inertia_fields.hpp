#pragma once
// How a gear crosses the pipe.

#include "geared_inertia.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
struct Fields<GearWheel> {
  static constexpr auto list = fieldList("teeth", &GearWheel::teeth, "inertia", &GearWheel::inertia,
                                         "mass", &GearWheel::mass, "axle", &GearWheel::axle);
};

}  // namespace carom::grading
