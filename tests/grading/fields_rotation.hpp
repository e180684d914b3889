#pragma once
// How the types of chapter 1 cross the pipe.

#include "carom/rotation/euler_angles.hpp"
#include "carom/rotation/quaternion.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
struct Fields<Quaternion> {
  static constexpr auto list =
      fieldList("w", &Quaternion::w, "x", &Quaternion::x, "y", &Quaternion::y, "z", &Quaternion::z);
};

template <>
struct Fields<EulerAngles> {
  static constexpr auto list =
      fieldList("roll", &EulerAngles::roll, "pitch", &EulerAngles::pitch, "yaw", &EulerAngles::yaw);
};

}  // namespace carom::grading
