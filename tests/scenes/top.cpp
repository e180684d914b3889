// A spinning top on its tip, which friction holds: no joint, one contact.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "carom/core/cross.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "scenes/families.hpp"

namespace carom::scenes {
namespace {

// Case N10: moments about the tip and along the axis, the distance from the tip to the centre of
// mass, the tilt and the spin along the axis.
constexpr Real kMass = 1, kAcross = 0.3, kAlong = 0.1, kArm = 0.5, kSpin = 60, kGravity = 9.81;
constexpr Real kTilt = std::numbers::pi / 6;

// The slow root of I1 cos(tilt) W^2 - I3 w3 W + m g l = 0, without cancellation.
Real precession() {
  const Real half = kAlong * kSpin / 2, pull = kMass * kGravity * kArm;
  return pull / (half + std::sqrt(half * half - kAcross * std::cos(kTilt) * pull));
}

// The axis of the top, which goes round the vertical once in 2 pi / W.
Vector3 axisAt(Real time) {
  const Real phase = precession() * time;
  return {std::sin(kTilt) * std::cos(phase), std::sin(kTilt) * std::sin(phase), std::cos(kTilt)};
}

class TopJudge : public Judge {
 public:
  void see(Real time, std::span<const State> bodies) override {
    const State& top = bodies[1];
    const Vector3 axis = rotatePoint(top.orientation, Vector3::UnitZ());
    axis_ = 2 * std::asin(std::min(1.0, (axis - axisAt(time)).norm() / 2));
    tilt_ = std::atan2(std::hypot(axis.x(), axis.y()), axis.z()) - kTilt;
    position_ = (top.position - kArm * axisAt(time)).norm();
  }
  std::vector<Figure> figures() const override {
    return {{"axis [rad]", axis_}, {"tilt [rad]", tilt_}, {"position [m]", position_}};
  }

 private:
  Real axis_ = 0, tilt_ = 0, position_ = 0;
};

// The tip, and a ring around the axis above the centre of mass that nothing touches.
Shape tipAndRing() {
  constexpr int kCorners = 8;
  constexpr Real kRadius = 0.2, kAbove = 0.1;
  std::vector<Vector3> points{{0, 0, -kArm}};
  for (int i = 0; i < kCorners; ++i) {
    const Real angle = 2 * std::numbers::pi * i / kCorners;
    points.emplace_back(kRadius * std::cos(angle), kRadius * std::sin(angle), kAbove);
  }
  return hullOfPoints(points);
}

}  // namespace

Scene topScene() {
  Body top{.shape = tipAndRing()};
  top.mass = kMass;
  const Real acrossCentre = kAcross - kMass * kArm * kArm;
  top.moments = {acrossCentre, acrossCentre, kAlong};
  top.friction = 1, top.restitution = 0;
  const Vector3 axis = axisAt(0);
  top.start.orientation = axisAngleToQuaternion(Vector3::UnitY(), kTilt);
  top.start.position = kArm * axis;
  // The whole angular velocity has the part w3 along the axis.
  top.start.angularVelocity =
      precession() * Vector3::UnitZ() + (kSpin - precession() * std::cos(kTilt)) * axis;
  top.start.velocity = cross(top.start.angularVelocity, top.start.position);
  Scene scene;
  scene.name = "N10_top", scene.title = "a spinning top precesses on its tip";
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero()), top};
  scene.duration = 2;
  scene.judge = [](const Scene&) { return std::make_unique<TopJudge>(); };
  return scene;
}

}  // namespace carom::scenes
