#include "carom/detection/pose.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/detection/limits.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom/rotation/require_rotation.hpp"

namespace carom {

Pose poseOf(const Quaternion& q_WB, const Vector3& p_WB) {
  requireCoordinates(p_WB, "position");
  return {quaternionToMatrix(q_WB), p_WB};
}

PlanarPose planarPoseOf(Real angle, const Vector2& p_WB) {
  requireFinite(angle, "angle");
  requireCoordinate(p_WB.x(), "position.x");
  requireCoordinate(p_WB.y(), "position.y");
  const SineCosine turn = sineCosine(angle);
  return {turn.cosine, turn.sine, p_WB};
}

void requireUsable(const Pose& pose, const char* name) {
  requireRotation(pose.R_WB, name);
  requireCoordinates(pose.p_WB, name);
}

void requireUsable(const PlanarPose& pose, const char* name) {
  requireCoordinate(pose.p_WB.x(), name);
  requireCoordinate(pose.p_WB.y(), name);
  const Real squared = pose.cosine * pose.cosine + pose.sine * pose.sine;
  if (!(std::abs(squared - 1) <= kRotationTolerance)) {
    reject(name, "(" + toText(pose.cosine) + ", " + toText(pose.sine) + ")",
           "must be a cosine and a sine, with squares that add to 1");
  }
}

}  // namespace carom
