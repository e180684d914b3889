#include "carom/rotation/slerp.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Quaternion slerp(const Quaternion& a, const Quaternion& b, Real t) {
  requireFinite(t, "t");
  const Quaternion unitA = renormalize(a);
  const Quaternion unitB = renormalize(b);
  const Vector4 from(unitA.w, unitA.x, unitA.y, unitA.z);
  Vector4 to(unitB.w, unitB.x, unitB.y, unitB.z);
  if (from.dot(to) < 0) to = -to;  // the same rotation, the short way

  const Real angle = 2 * arctangent2((from - to).norm(), (from + to).norm());
  if (angle == 0) return unitA;
  const Vector4 q = (sine((1 - t) * angle) * from + sine(t * angle) * to) / sine(angle);
  return renormalize({q(0), q(1), q(2), q(3)});
}

}  // namespace carom
