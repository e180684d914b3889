// Hands the gap to conservativeAdvancement, with one bound for the whole of the time: no normal,
// so safe too, with more steps.
#include "carom/toi/toi_rotating.hpp"

#include <algorithm>
#include <vector>

#include "carom/core/checks.hpp"
#include "carom/detection/gjk_distance.hpp"
#include "carom/toi/conservative_advancement.hpp"

namespace carom {

TimeOfImpact toiRotating(std::span<const Vector3> a, const Sweep& A, std::span<const Vector3> b,
                         const Sweep& B, Real duration, Real tolerance, int maxSteps) {
  requireUsable(A, "A");
  requireUsable(B, "B");
  requirePositive(tolerance, "tolerance");
  const auto placed = [](std::span<const Vector3> corners, const Sweep& sweep, Real time) {
    std::vector<Vector3> world(corners.begin(), corners.end());
    const Pose pose = poseAt(sweep, time);
    for (Vector3& corner : world) corner = pose.R_WB * corner + pose.p_WB;
    return world;
  };
  PointDistance last;
  const auto gap = [&](Real time) {
    last = gjkDistance(placed(a, A, time), placed(b, B, time));
    return last.distance;
  };
  if (gap(0) == 0) return {.status = ImpactStatus::kOverlapping};

  Real fastest = 1e-9;
  const Vector3 velocity = B.velocity - A.velocity, change = B.acceleration - A.acceleration;
  fastest += std::max(velocity.norm(), (velocity + duration * change).norm());
  Real ofA = 0, ofB = 0;
  for (const Vector3& corner : a) ofA = std::max(ofA, (corner - A.centre).squaredNorm());
  for (const Vector3& corner : b) ofB = std::max(ofB, (corner - B.centre).squaredNorm());
  fastest += std::sqrt(ofA * A.angularVelocity.squaredNorm());
  fastest += std::sqrt(ofB * B.angularVelocity.squaredNorm());

  TimeOfImpact result = conservativeAdvancement(gap, fastest, duration, tolerance, maxSteps);
  result.point = (last.pointA + last.pointB) / 2;
  if (last.distance > 0) result.normal = (last.pointB - last.pointA).normalized();
  return result;
}

}  // namespace carom
