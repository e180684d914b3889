// Exercise 01.slerp: the orientation between two others.
// Check it with: ./course check 01.slerp

#include "carom/rotation/slerp.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/todo.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Quaternion slerp(const Quaternion& a, const Quaternion& b, Real t) {
  requireFinite(t, "t");
  const Quaternion unitA = renormalize(a);
  const Quaternion unitB = renormalize(b);

  //# solution
  const Vector4 from(unitA.w, unitA.x, unitA.y, unitA.z);
  Vector4 to(unitB.w, unitB.x, unitB.y, unitB.z);
  if (from.dot(to) < 0) to = -to;  // the same rotation, the short way

  const Real angle = 2 * arctangent2((from - to).norm(), (from + to).norm());
  if (angle == 0) return unitA;
  const Vector4 q = (sine((1 - t) * angle) * from + sine(t * angle) * to) / sine(angle);
  return renormalize({q(0), q(1), q(2), q(3)});
  //# stub
  // Which turn leads from unitA to unitB, by the shorter way? Make the fraction t of it.
  //#| static_cast<void>(unitA);
  //#| static_cast<void>(unitB);
  //#| return todo<Quaternion>("slerp");
  //# end
}

}  // namespace carom
