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

// How fast turning can carry any corner.
Real fastestTurn(std::span<const Vector3> corners, const Sweep& sweep) {
  Real farthest = 0;
  for (const Vector3& corner : corners) {
    farthest = std::max(farthest, (corner - sweep.centre).norm());
  }
  return sweep.angularVelocity.norm() * farthest;
}

}  // namespace

TimeOfImpact toiRotating(std::span<const Vector3> a, const Sweep& A, std::span<const Vector3> b,
                         const Sweep& B, Real duration, Real tolerance, int maxSteps) {
  requireUsable(A, "A");
  requireUsable(B, "B");
  requireNonNegative(duration, "duration");
  requirePositive(tolerance, "tolerance");
  if (maxSteps < 1) reject("maxSteps", std::to_string(maxSteps), "must be positive");
  const Real turning = fastestTurn(a, A) + fastestTurn(b, B);
  const Vector3 acceleration = B.acceleration - A.acceleration;

  TimeOfImpact result;
  while (true) {
    const PointDistance found =
        gjkDistance(cornersAt(a, A, result.time), cornersAt(b, B, result.time));
    result.gap = found.distance;
    result.point = (found.pointA + found.pointB) / 2;
    if (found.distance == 0 && result.steps == 0) {
      result.status = ImpactStatus::kOverlapping;
      return result;
    }
    if (found.distance > 0) result.normal = (found.pointB - found.pointA) / found.distance;
    if (result.gap <= tolerance) {
      result.status = ImpactStatus::kHit;
      return result;
    }
    if (result.time == duration) return {};
    if (result.steps == maxSteps) {
      result.status = ImpactStatus::kLimit;
      return result;
    }

    // The fastest that the gap can close along its normal from now to the end.
    const Real left = duration - result.time;
    const Vector3 velocity = B.velocity - A.velocity + result.time * acceleration;
    const Real centres = -result.normal.dot(velocity);
    const Real later = centres - left * result.normal.dot(acceleration);
    const Real fastest = std::max(centres, later) + turning;
    ++result.steps;
    result.time = fastest * left > result.gap ? result.time + result.gap / fastest : duration;
  }
}

}  // namespace carom
