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

  // Which turn leads from unitA to unitB, by the shorter way? Make the fraction t of it.
  static_cast<void>(unitA);
  static_cast<void>(unitB);
  return todo<Quaternion>("slerp");
}

}  // namespace carom
