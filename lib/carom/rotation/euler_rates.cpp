#include "carom/rotation/euler_rates.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"

namespace carom {

Matrix3 eulerRateMatrix(const EulerAngles& angles) {
  requireFinite(angles.roll, "roll");
  requireFinite(angles.pitch, "pitch");
  requireFinite(angles.yaw, "yaw");

  const SineCosine pitch = sineCosine(angles.pitch);
  const SineCosine yaw = sineCosine(angles.yaw);
  Matrix3 E;
  // clang-format off
  E << yaw.cosine * pitch.cosine, -yaw.sine,   0,
       yaw.sine * pitch.cosine,    yaw.cosine, 0,
      -pitch.sine,                 0,          1;
  // clang-format on
  return E;
}

}  // namespace carom
