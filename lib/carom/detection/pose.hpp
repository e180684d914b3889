#pragma once
// Where is a body, and which way does it look?
//
// Method: a rotation matrix and the place of the body's origin. x_W = R_WB x_B + p_WB.
// Why a matrix: detection turns dozens of points and axes per pair, and nine products per point are
// cheaper than a quaternion's sandwich; the body keeps its quaternion and makes the pose once per
// step. Why relativePose() takes the difference of the positions first: two bodies 1000 km from the
// origin and 1 m apart know their places to 1e-10 m, but the difference of two neighbouring
// doubles is exact, so all that follows is computed with the digits of a pair at the origin.
// Not handled: scaling and shearing; a pose is rigid.

#include "carom/core/elementary.hpp"
#include "carom/core/real.hpp"
#include "carom/rotation/quaternion.hpp"

namespace carom {

/// A rigid placement of a body in space, world from body. Default: the identity. \ingroup detection
struct Pose {
  Matrix3 R_WB = Matrix3::Identity();  ///< rotation, body to world [1]
  Vector3 p_WB = Vector3::Zero();      ///< the body's origin [m, world]
};

/// A rigid placement of a planar body, world from body. Default: the identity. \ingroup detection
struct PlanarPose {
  Real cosine = 1;                 ///< cosine of the angle from the world's x axis to the body's
  Real sine = 0;                   ///< sine of that angle, counter-clockwise positive
  Vector2 p_WB = Vector2::Zero();  ///< the body's origin [m, world]
};

/// The pose of a body whose orientation is kept as a quaternion.
/// \param q_WB rotation, body to world; any norm but zero
/// \param p_WB the body's origin [m, world]
/// \return the pose
/// \throws InvalidInput if the quaternion is zero or a number is not finite
/// \ingroup detection
Pose poseOf(const Quaternion& q_WB, const Vector3& p_WB);

/// The pose of a planar body.
/// \param angle from the world's x axis to the body's, counter-clockwise [rad]
/// \param p_WB the body's origin [m, world]
/// \return the pose
/// \throws InvalidInput if a number is not finite
/// \ingroup detection
PlanarPose planarPoseOf(Real angle, const Vector2& p_WB);

/// Lets only rigid, finite poses pass.
/// \param pose the pose \param name what it is called, for the message
/// \throws InvalidInput if a number is not finite or R_WB is not a rotation (kRotationTolerance)
/// \ingroup detection
void requireUsable(const Pose& pose, const char* name);

/// Lets only rigid, finite planar poses pass.
/// \param pose the pose \param name what it is called, for the message
/// \throws InvalidInput if a number is not finite or sine and cosine do not lie on the unit circle
/// \ingroup detection
void requireUsable(const PlanarPose& pose, const char* name);

/// A point of the body in world coordinates. \param pose of the body
/// \param x_B point [m, body] \return the same point [m, world] \ingroup detection
inline Vector3 pointToWorld(const Pose& pose, const Vector3& x_B) {
  return pose.R_WB * x_B + pose.p_WB;
}

/// A point of the world in body coordinates. \param pose of the body
/// \param x_W point [m, world] \return the same point [m, body] \ingroup detection
inline Vector3 pointToBody(const Pose& pose, const Vector3& x_W) {
  return pose.R_WB.transpose() * (x_W - pose.p_WB);
}

/// A direction of the body in world coordinates. \param pose of the body
/// \param d_B direction [any unit, body] \return the same direction [same unit, world]
/// \ingroup detection
inline Vector3 directionToWorld(const Pose& pose, const Vector3& d_B) {
  return pose.R_WB * d_B;
}

/// A direction of the world in body coordinates. \param pose of the body
/// \param d_W direction [any unit, world] \return the same direction [same unit, body]
/// \ingroup detection
inline Vector3 directionToBody(const Pose& pose, const Vector3& d_W) {
  return pose.R_WB.transpose() * d_W;
}

/// A point of a planar body in world coordinates. \param pose of the body
/// \param x_B point [m, body] \return the same point [m, world] \ingroup detection
inline Vector2 pointToWorld(const PlanarPose& pose, const Vector2& x_B) {
  return {pose.cosine * x_B.x() - pose.sine * x_B.y() + pose.p_WB.x(),
          pose.sine * x_B.x() + pose.cosine * x_B.y() + pose.p_WB.y()};
}

/// A direction of a planar body in world coordinates. \param pose of the body
/// \param d_B direction [any unit, body] \return the same direction [same unit, world]
/// \ingroup detection
inline Vector2 directionToWorld(const PlanarPose& pose, const Vector2& d_B) {
  return {pose.cosine * d_B.x() - pose.sine * d_B.y(), pose.sine * d_B.x() + pose.cosine * d_B.y()};
}

/// A direction of the world in coordinates of a planar body. \param pose of the body
/// \param d_W direction [any unit, world] \return the same direction [same unit, body]
/// \ingroup detection
inline Vector2 directionToBody(const PlanarPose& pose, const Vector2& d_W) {
  return {pose.cosine * d_W.x() + pose.sine * d_W.y(), pose.cosine * d_W.y() - pose.sine * d_W.x()};
}

/// A point of the world in coordinates of a planar body. \param pose of the body
/// \param x_W point [m, world] \return the same point [m, body] \ingroup detection
inline Vector2 pointToBody(const PlanarPose& pose, const Vector2& x_W) {
  return directionToBody(pose, x_W - pose.p_WB);
}

/// B's pose as A sees it: rotation R_AB, and p_AB. The positions are subtracted before they are
/// turned, so that digits are not lost far from the origin.
/// \param A pose of the body whose frame is wanted
/// \param B pose of the other body
/// \return the pose of B in the frame of A
/// \ingroup detection
inline Pose relativePose(const Pose& A, const Pose& B) {
  return {A.R_WB.transpose() * B.R_WB, A.R_WB.transpose() * (B.p_WB - A.p_WB)};
}

/// B's pose as A sees it, in the plane.
/// \param A pose of the body whose frame is wanted
/// \param B pose of the other body
/// \return the pose of B in the frame of A
/// \ingroup detection
inline PlanarPose relativePose(const PlanarPose& A, const PlanarPose& B) {
  return {A.cosine * B.cosine + A.sine * B.sine, A.cosine * B.sine - A.sine * B.cosine,
          directionToBody(A, B.p_WB - A.p_WB)};
}

/// An order of poses, by position, then by the entries of the rotation. Methods that treat the
/// smaller one as A give (A, B) and (B, A) the same answer to the last bit.
/// \param A a pose \param B another
/// \return negative if A comes first, positive if B does, zero if they are the same
/// \ingroup detection
inline int comparePoses(const Pose& A, const Pose& B) {
  for (int k = 0; k < 3; ++k) {
    if (A.p_WB[k] != B.p_WB[k]) return A.p_WB[k] < B.p_WB[k] ? -1 : 1;
  }
  for (int k = 0; k < 9; ++k) {
    const Real ofA = A.R_WB.data()[k], ofB = B.R_WB.data()[k];
    if (ofA != ofB) return ofA < ofB ? -1 : 1;
  }
  return 0;
}

/// The same in the plane: by position, then by cosine and sine of the angle.
/// \param A a pose \param B another
/// \return negative if A comes first, positive if B does, zero if they are the same
/// \ingroup detection
inline int comparePoses(const PlanarPose& A, const PlanarPose& B) {
  for (int k = 0; k < 2; ++k) {
    if (A.p_WB[k] != B.p_WB[k]) return A.p_WB[k] < B.p_WB[k] ? -1 : 1;
  }
  if (A.cosine != B.cosine) return A.cosine < B.cosine ? -1 : 1;
  if (A.sine != B.sine) return A.sine < B.sine ? -1 : 1;
  return 0;
}

/// The pose of a part of a body: first the part in the body, then the body in the world.
/// \param body pose of the body, world from body
/// \param part pose of the part, body from part
/// \return pose of the part, world from part
/// \ingroup detection
inline Pose composed(const Pose& body, const Pose& part) {
  return {body.R_WB * part.R_WB, pointToWorld(body, part.p_WB)};
}

/// The pose of a part of a planar body.
/// \param body pose of the body, world from body
/// \param part pose of the part, body from part
/// \return pose of the part, world from part
/// \ingroup detection
inline PlanarPose composed(const PlanarPose& body, const PlanarPose& part) {
  return {body.cosine * part.cosine - body.sine * part.sine,
          body.sine * part.cosine + body.cosine * part.sine, pointToWorld(body, part.p_WB)};
}

}  // namespace carom
