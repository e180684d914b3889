// With the angular momentum along the body's axes, and then on the right; the angular velocity goes
// round by the turn about the axis, taken back.
#include "carom/core/checks.hpp"
#include "carom/motion/exact_rotor.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/rotate_point.hpp"

namespace carom {

RotorState exactRotor(const RoundMoments& moments, const RotorState& start, Real time) {
  requirePositive(moments.across, "across");
  requirePositive(moments.along, "along");
  requireUsable(start);
  requireFinite(time, "time");
  const Vector3& w = start.angularVelocity;
  const Real ratio = moments.along / moments.across;
  const Quaternion swing = quaternionExponential(time * Vector3(w.x(), w.y(), ratio * w.z()));
  const Quaternion spin = quaternionExponential({0, 0, (1 - ratio) * w.z() * time});
  const Quaternion both = hamiltonProduct(swing, spin);
  return {hamiltonProduct(start.q_WB, both), rotatePoint(conjugate(spin), w)};
}

}  // namespace carom
