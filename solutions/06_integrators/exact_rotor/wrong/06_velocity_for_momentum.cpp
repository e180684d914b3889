// Exercise 06.exact_rotor: where will a top in free fall point in an hour?
// Check it with: ./course check 06.exact_rotor

#include "carom/motion/exact_rotor.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
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
  const Vector3& w = start.angularVelocity;
  const Vector3 rate = w;
  const Real angle = w.z() * (moments.across - moments.along) / moments.across * time;
  const Quaternion aboutMomentum = quaternionExponential(rotatePoint(start.q_WB, rate * time));
  const Quaternion aboutAxis = quaternionExponential({0, 0, angle});
  const Quaternion turned = hamiltonProduct(aboutMomentum, start.q_WB);
  const Real c = std::cos(angle), s = std::sin(angle);
  return {renormalize(hamiltonProduct(turned, aboutAxis)),
          {c * w.x() + s * w.y(), c * w.y() - s * w.x(), w.z()}};
}

}  // namespace carom
