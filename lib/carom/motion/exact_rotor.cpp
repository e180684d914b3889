#include "carom/motion/exact_rotor.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

RotorState exactRotor(const RoundMoments& moments, const RotorState& start, Real time) {
  requirePositive(moments.across, "across");
  requirePositive(moments.along, "along");
  requireUsable(start);
  requireFinite(time, "time");
  const Vector3& w = start.angularVelocity;

  // About L. In the body's axes the rotation stands to the right of the attitude.
  const Vector3 rate = {w.x(), w.y(), w.z() * moments.along / moments.across};
  const Quaternion aboutMomentum = quaternionExponential(rate * time);

  // About the axis.
  const Real angle = w.z() * (moments.across - moments.along) / moments.across * time;
  const Quaternion aboutAxis = quaternionExponential({0, 0, angle});

  const SineCosine back = sineCosine(-angle);
  return {
      renormalize(hamiltonProduct(hamiltonProduct(start.q_WB, aboutMomentum), aboutAxis)),
      {back.cosine * w.x() - back.sine * w.y(), back.sine * w.x() + back.cosine * w.y(), w.z()}};
}

}  // namespace carom
