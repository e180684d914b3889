#pragma once
// How a row of the table crosses the pipe.

#include "grading/fields_manifold.hpp"
#include "tilted_contact.hpp"

namespace carom::grading {

template <>
struct Fields<TiltedContact> {
  static constexpr auto list =
      fieldList("tilt", &TiltedContact::tilt, "jump", &TiltedContact::jump, "depthChange",
                &TiltedContact::depthChange);
};

}  // namespace carom::grading
