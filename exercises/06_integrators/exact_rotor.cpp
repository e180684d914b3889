// Exercise 06.exact_rotor: where will a top in free fall point in an hour?
// Check it with: ./course check 06.exact_rotor

#include "carom/motion/exact_rotor.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"
#include "carom/rotation/rotate_point.hpp"

namespace carom {

RotorState exactRotor(const RoundMoments& moments, const RotorState& start, Real time) {
  // Given: what no body has is refused.
  requirePositive(moments.across, "across");
  requirePositive(moments.along, "along");
  requireUsable(start);
  requireFinite(time, "time");
  // quaternionExponential(v) turns by |v| about v: the half is in it. hamiltonProduct(p, q) turns
  // by q first. rotatePoint(q_WB, v) takes a vector from the body's axes to the world's.
  return todo<RotorState>("exactRotor");
}

}  // namespace carom
