// Exercise 07.toi_rotating: when do two bodies touch that turn while they move?
// Check it with: ./course check 07.toi_rotating

#include "carom/toi/toi_rotating.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "carom/core/checks.hpp"
#include "carom/detection/gjk_distance.hpp"

namespace carom {
namespace {

std::vector<Vector3> cornersAt(std::span<const Vector3> corners, const Sweep& sweep, Real time) {
  const Pose pose = poseAt(sweep, time);
  std::vector<Vector3> placed;
  for (const Vector3& corner : corners) placed.push_back(pointToWorld(pose, corner));
  return placed;
}

// Given: the gap at a time, by GJK, with the normal from A to B and the point in the middle.
TimeOfImpact look(std::span<const Vector3> a, const Sweep& A, std::span<const Vector3> b,
                  const Sweep& B, Real time) {
  const PointDistance found = gjkDistance(cornersAt(a, A, time), cornersAt(b, B, time));
  TimeOfImpact result;
  result.time = time;
  result.gap = found.distance;
  result.point = (found.pointA + found.pointB) / 2;
  if (found.distance > 0) result.normal = (found.pointB - found.pointA) / found.distance;
  return result;
}

}  // namespace

TimeOfImpact toiRotating(std::span<const Vector3> a, const Sweep& A, std::span<const Vector3> b,
                         const Sweep& B, Real duration, Real tolerance, int maxSteps) {
  // Given: what cannot be worked with is refused.
  requireUsable(A, "A");
  requireUsable(B, "B");
  requireNonNegative(duration, "duration");
  requirePositive(tolerance, "tolerance");
  if (maxSteps < 1) reject("maxSteps", std::to_string(maxSteps), "must be positive");
  // Given: the first look. Its status is kNoHit, its steps are 0.
  [[maybe_unused]] TimeOfImpact result = look(a, A, b, B, 0);
  const auto turnOf = [](std::span<const Vector3> corners, const Sweep& sweep) {
    Real farthest = 0;
    for (const Vector3& corner : corners) {
      farthest = std::max(farthest, (corner - sweep.centre).norm());
    }
    return sweep.angularVelocity.norm() * farthest;
  };
  const Real turning = turnOf(a, A);
  const Vector3 acceleration = B.acceleration - A.acceleration;
  result.status = ImpactStatus::kOverlapping;
  if (result.gap == 0) return result;
  for (int steps = 0; result.gap > tolerance; result.steps = ++steps) {
    result.status = ImpactStatus::kNoHit;
    if (result.time == duration) return result;
    result.status = ImpactStatus::kLimit;
    if (steps == maxSteps) return result;
    const Vector3 velocity = B.velocity - A.velocity + result.time * acceleration;
    const Real left = duration - result.time;
    const Real now = -result.normal.dot(velocity);
    const Real end = now - left * result.normal.dot(acceleration);
    const Real fastest = std::max(now, end) + turning;
    const bool toEnd = fastest * left <= result.gap;
    result = look(a, A, b, B, toEnd ? duration : result.time + result.gap / fastest);
  }
  result.status = ImpactStatus::kHit;
  return result;
}

}  // namespace carom
