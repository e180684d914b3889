#include "carom/rotation/unit_axis.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"

namespace carom {

Vector3 unitAxis(const Vector3& axis, const char* name) {
  requireFinite(axis, name);
  if (axis.isZero(0)) reject(name, toText(axis), "must not be zero: it has no direction");
  const Vector3 scaled = scaledToOne(axis);  // so that no square overflows or vanishes
  return scaled / scaled.norm();
}

}  // namespace carom
