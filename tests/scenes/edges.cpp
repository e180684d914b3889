// Boxes that turn about an edge: no slipping, no hopping.

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/detection/pose.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "scenes/exact.hpp"
#include "scenes/families.hpp"

namespace carom::scenes {
namespace {

constexpr Real kHalfDepth = 0.25;  // along y, which no answer depends on [m]
constexpr Real kGripping = 1;      // friction that nothing here overcomes

// The angle by which a body has turned about y.
Real angleAboutY(const State& body) {
  return 2 * std::atan2(body.orientation.y, body.orientation.w);
}

// A moment between two looks.
struct Crossing {
  Real time = 0, rate = 0;
};

// --- S7

class DominoJudge : public Judge {
 public:
  void see(Real time, std::span<const State> bodies) override {
    const State& box = bodies[1];
    const Real angle = angleAboutY(box), rate = box.angularVelocity.y();
    const Vector3 edge =
        pointToWorld(poseOfState(box), Vector3(kBox.thickness / 2, 0, -kBox.height / 2));
    if (time == 0) edge_ = edge;
    if (!found_) slip_ = std::max(slip_, (edge - edge_).norm());
    if (!found_ && time > 0 && angle >= kHit) {
      fall();
      found_ = true;
    }
    time_ = time, angle_ = angle, rate_ = rate;
  }
  std::vector<Figure> figures() const override {
    return {{"time [s]", hit_.time - tippingTime(kBox, kHit)},
            {"spin [rad/s]", hit_.rate - tippingSpin(kBox, kHit)},
            {"edge slips [m]", slip_}};
  }
  static constexpr Tipping kBox{};
  static inline const Real kHit = std::asin(0.5);

 private:
  // From the last look to the hit by energy and Simpson's rule: a curve between two looks would be
  // wrong by more than good engines are.
  void fall() {
    const auto square = [](Real angle) { return std::pow(tippingSpin(kBox, angle), 2); };
    const Real start = rate_ * rate_ - square(angle_);
    const auto slowness = [&](Real angle) {
      return 1 / std::sqrt(std::max(start + square(angle), 1e-6));
    };
    constexpr int kParts = 32;
    const Real h = (kHit - angle_) / kParts;
    Real sum = slowness(angle_) + slowness(kHit);
    for (int i = 1; i < kParts; ++i) sum += (i % 2 == 1 ? 4 : 2) * slowness(angle_ + i * h);
    hit_ = {time_ + sum * h / 3, 1 / slowness(kHit)};
  }

  Vector3 edge_ = Vector3::Zero();
  Crossing hit_;
  bool found_ = false;
  Real time_ = 0, angle_ = 0, rate_ = 0, slip_ = 0;
};

// --- S10

class RockingJudge : public Judge {
 public:
  void see(Real time, std::span<const State> bodies) override {
    const Real angle = angleAboutY(bodies[1]), rate = bodies[1].angularVelocity.y();
    if (!fallen_ && time > 0 && angle <= 0) {
      // What comes after the impact says nothing about its time: free motion from the last look.
      fall();
      fallen_ = true;
    }
    // The largest angle on the other side: where the rate changes sign, by energy.
    if (fallen_ && !turned_ && angle < 0 && rate_ < 0 && rate >= 0) {
      const Real rise = std::cos(exact_.alpha + angle_) + rate_ * rate_ / (2 * pull2());
      next_ = std::acos(std::min(rise, Real(1))) - exact_.alpha;
      turned_ = true;
    }
    time_ = time, angle_ = angle, rate_ = rate;
    sideways_ = std::max(sideways_, std::abs(bodies[1].position.y()));
  }
  std::vector<Figure> figures() const override {
    return {{"impact time [s]", impact_.time - exact_.impactTime},
            {"spin before [rad/s]", -impact_.rate - exact_.before},
            {"next angle [rad]", -next_ - exact_.nextAngle},
            {"sideways [m]", sideways_}};
  }

 private:
  static Real pull2() {
    const Rocking block;
    return 3 * block.gravity / (4 * std::hypot(block.halfWidth, block.halfHeight));
  }

  void fall() {
    const Real p2 = pull2();
    const auto pull = [&](Real angle) { return -p2 * std::sin(exact_.alpha - angle); };
    constexpr Real kPiece = 1e-5;  // of velocity Verlet, whose error is then 1e-10 [s]
    Real angle = angle_, rate = rate_, time = time_;
    while (angle > 0) {
      const Real half = rate + kPiece / 2 * pull(angle);
      angle += kPiece * half;
      rate = half + kPiece / 2 * pull(angle);
      time += kPiece;
    }
    // Back by what was too much, which is less than a piece.
    impact_ = {time - angle / rate, rate - angle / rate * pull(0)};
  }

  RockingAnswer exact_ = rockingAnswer({});
  Crossing impact_;
  bool fallen_ = false, turned_ = false;
  Real time_ = 0, angle_ = 0, rate_ = 0, next_ = 0, sideways_ = 0;
};

// --- I19

// In the plane of the case: x to the right, y up is z here, and a turn about its z is one about -y.
const Vector3 kCornerArm(-0.8, 0, -1.1);
const Vector3 kCornerVelocity(1, 0, -3);
constexpr Real kCornerSpin = 2;
constexpr Real kCornerTime = 0.105;  // of the impact, not at the end of a step [s]
constexpr Real kCornerInertia = 2.0 / 3;

class CornerJudge : public Judge {
 public:
  void see(Real, std::span<const State> bodies) override {
    last_ = bodies[1];
  }
  std::vector<Figure> figures() const override {
    // Case I19, exact rationals: both directions of the contact at once.
    return {{"velocity [m/s]",
             std::hypot(last_.velocity.x() - 6611.0 / 3775, last_.velocity.z() - 7749.0 / 7550)},
            {"spin [rad/s]", -last_.angularVelocity.y() + 1202.0 / 755}};
  }

 private:
  State last_;
};

}  // namespace

Scene dominoScene() {
  const Tipping& t = DominoJudge::kBox;
  Body box = boxBody({t.thickness / 2, kHalfDepth, t.height / 2}, 1);
  box.friction = kGripping, box.restitution = 0;
  box.start.position = {-t.thickness / 2, 0, t.height / 2};
  box.start.angularVelocity = {0, t.spin, 0};
  box.start.velocity = cross(box.start.angularVelocity, box.start.position);
  Scene scene;
  scene.name = "S7_domino", scene.title = "a domino tips over its lower edge";
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero()), box};
  scene.duration = 0.7;
  scene.judge = [](const Scene&) { return std::make_unique<DominoJudge>(); };
  return scene;
}

Scene rockingScene() {
  const Rocking r;
  const RockingAnswer answer = rockingAnswer(r);
  const Real angle = answer.alpha / 2;
  // It stands on its right edge (+x), turned clockwise seen along y.
  Body block = boxBody({r.halfWidth, kHalfDepth, r.halfHeight}, 1);
  block.friction = kGripping, block.restitution = 0;
  block.start.orientation = axisAngleToQuaternion({0, 1, 0}, angle);
  const Pose turned = poseOf(block.start.orientation, Vector3::Zero());
  block.start.position = -pointToWorld(turned, {r.halfWidth, 0, -r.halfHeight});
  Scene scene;
  scene.name = "S10_rocking", scene.title = "a block rocks from one edge to the other";
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero()), block};
  scene.duration = 1.2;
  scene.judge = [](const Scene&) { return std::make_unique<RockingJudge>(); };
  return scene;
}

Scene cornerScene() {
  const Real half = kCornerArm.norm() / std::sqrt(2.0);  // a square whose corner is at the arm
  Body square = boxBody({half, kHalfDepth, half}, 1);
  square.moments = {1, kCornerInertia, 1};
  square.friction = kGripping, square.restitution = 0.5;
  // Turned so that the corner (-, -) points along the arm at the impact.
  const Real atImpact = std::atan2(-1.1, -0.8) - std::atan2(-1.0, -1.0);
  const Real angle = -(atImpact - kCornerSpin * kCornerTime);
  square.start.orientation = axisAngleToQuaternion({0, 1, 0}, angle);
  square.start.position = Vector3(0, 0, 1.1) - kCornerTime * kCornerVelocity;
  square.start.velocity = kCornerVelocity;
  square.start.angularVelocity = {0, -kCornerSpin, 0};
  Scene scene;
  scene.name = "I19_corner", scene.title = "a square hits the floor with a corner and sticks";
  scene.gravity = Vector3::Zero();
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero()), square};
  scene.duration = 0.2, scene.bounces = true;
  scene.judge = [](const Scene&) { return std::make_unique<CornerJudge>(); };
  return scene;
}

}  // namespace carom::scenes
