#include "carom/toi/sub_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/toi/moving_core.hpp"

namespace carom {
namespace {

// No point of the body is carried faster than this by turning.
Real fastestTurn(const Shape& shape, const Sweep& sweep) {
  Real fromAxis = 0;
  for (const detail::MovingCore& part : detail::movingCores(shape, sweep)) {
    fromAxis = std::max(fromAxis, part.fromAxis);
  }
  return fromAxis * length(sweep.angularVelocity);
}

}  // namespace

int subStepsFor(const Shape& a, const Sweep& A, const Shape& b, const Sweep& B, Real duration,
                Real depth) {
  detail::requireSearchable(a, A, b, B, duration);
  requirePositive(depth, "depth");
  const Vector3 velocity = B.velocity - A.velocity, acceleration = B.acceleration - A.acceleration;
  // A parabola is fastest at one of its ends.
  const Real fastest = std::max(length(velocity), length(velocity + duration * acceleration)) +
                       fastestTurn(a, A) + fastestTurn(b, B);
  const Real travelled = fastest * duration;
  if (signedDistance(a, A.start, b, B.start).separation > travelled) return 0;
  const Real parts = std::max(Real(1), std::ceil(travelled / (2 * depth)));
  if (!(parts <= std::numeric_limits<int>::max())) {
    reject("parts", toText(parts), "must be less than 2^31; ask for a larger depth");
  }
  return static_cast<int>(parts);
}

TimeOfImpact contactBySubSteps(const Shape& a, const Sweep& A, const Shape& b, const Sweep& B,
                               Real duration, int parts, Real tolerance) {
  detail::requireSearchable(a, A, b, B, duration);
  requirePositive(tolerance, "tolerance");
  if (parts < 1) reject("parts", std::to_string(parts), "must be positive");
  int looks = 0;
  const auto lookAt = [&](Real time) {
    ++looks;
    return signedDistance(a, poseAt(A, time), b, poseAt(B, time));
  };
  const auto answer = [&](ImpactStatus status, Real time, const Separation& s) {
    return TimeOfImpact{status, time, (s.pointA + s.pointB) / 2, s.normal, s.separation, looks};
  };
  Separation before = lookAt(0);
  if (before.separation < -tolerance) return answer(ImpactStatus::kOverlapping, 0, before);
  if (before.separation <= tolerance) return answer(ImpactStatus::kHit, 0, before);
  Real apart = 0;
  for (int i = 1; i <= parts; ++i) {
    Real met = duration * i / parts;
    if (lookAt(met).separation > tolerance) {
      apart = met;
      continue;
    }
    // Halve: apart at one end, together at the other, until the gap at the first is small.
    before = lookAt(apart);
    while (before.separation > tolerance) {
      const Real middle = apart + (met - apart) / 2;
      if (middle <= apart || middle >= met) break;
      const Separation there = lookAt(middle);
      if (there.separation > 0) {
        apart = middle;
        before = there;
      } else {
        met = middle;
      }
    }
    return answer(ImpactStatus::kHit, apart, before);
  }
  TimeOfImpact none;
  none.steps = looks;
  return none;
}

}  // namespace carom
