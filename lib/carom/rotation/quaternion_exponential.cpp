#include "carom/rotation/quaternion_exponential.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/length.hpp"

namespace carom {
namespace {
constexpr Real kSeriesBelow = 0x1p-11;  // [rad]; the header says why
}

Quaternion quaternionExponential(const Vector3& rotationVector) {
  requireFinite(rotationVector, "rotationVector");
  const Real angle = length(rotationVector);
  requireFinite(angle, "|rotationVector|");

  const Real factor = angle < kSeriesBelow ? 0.5 - angle * angle / 48 : sine(angle / 2) / angle;
  const Vector3 v = factor * rotationVector;
  return {cosine(angle / 2), v.x(), v.y(), v.z()};
}

}  // namespace carom
