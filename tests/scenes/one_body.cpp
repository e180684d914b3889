// One body, and an answer in closed form for every moment.

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/impulse/bouncing_ball.hpp"
#include "carom/impulse/roll_ball.hpp"
#include "carom/impulse/slide_block.hpp"
#include "carom/motion/free_rotor.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "scenes/families.hpp"

namespace carom::scenes {
namespace {

constexpr Real kGravity = 9.81;  // [m/s^2]

// Is this one of the moments that are a multiple of `every` apart? Steps end there, but for
// rounding.
bool isMoment(Real time, Real every) {
  const Real count = time / every;
  return std::abs(count - std::round(count)) < 1e-6;
}

Real rootMean(Real sum, long count) {
  return count > 0 ? std::sqrt(sum / static_cast<Real>(count)) : 0;
}

// --- A

// The height against that of the closed form; the tops of the flights by a parabola through the
// highest sample and its neighbours, which is exact where the engine's flight is one.
class BounceJudge : public Judge {
 public:
  void see(Real time, std::span<const State> bodies) override {
    const Real height = bodies[1].position.z() - kRadius;
    if (seen_ >= 2 && last_[1] > last_[0] && last_[1] >= height) {
      const Real bend = last_[0] - 2 * last_[1] + height, lean = last_[0] - height;
      tops_.push_back(bend < 0 ? last_[1] - lean * lean / (8 * bend) : last_[1]);
    }
    last_ = {last_[1], height};
    ++seen_;
    if (!isMoment(time, 1.0 / 30)) return;
    const Real error = height - bounceBall({kDrop, 0}, {kRestitution, kGravity}, time).height;
    sum_ += error * error, ++count_;
    if (time <= 1 + 1e-9) fall_ += error * error, ++falls_;
    lowest_ = std::min(lowest_, height);
  }
  std::vector<Figure> figures() const override {
    std::vector<Figure> all{{"height rms [m]", rootMean(sum_, count_)},
                            {"free fall rms [m]", rootMean(fall_, falls_)},
                            {"penetration [m]", -lowest_}};
    Real exact = kDrop;
    for (std::size_t i = 0; i < 5; ++i) {
      exact *= kRestitution * kRestitution;
      // A top that the engine did not reach is missing by its height.
      const Real top = i < tops_.size() ? tops_[i] : 0;
      if (i % 2 == 0) all.push_back({"apex " + std::to_string(i + 1) + " [m]", top - exact});
    }
    return all;
  }

  static constexpr Real kRadius = 0.5, kDrop = 5, kRestitution = 0.8;

 private:
  std::array<Real, 2> last_{};
  std::vector<Real> tops_;
  Real sum_ = 0, fall_ = 0, lowest_ = 0;
  long count_ = 0, falls_ = 0, seen_ = 0;
};

// --- B and M

constexpr Real kSlideSpeed = 5, kSlideFriction = 0.5;

class SlideJudge : public Judge {
 public:
  explicit SlideJudge(Real x0) : x0_(x0) {}
  void see(Real time, std::span<const State> bodies) override {
    last_ = bodies[1];
    drift_ = std::max(drift_, std::abs(last_.position.y()));
    time_ = time;
  }
  std::vector<Figure> figures() const override {
    const Slope level{.friction = kSlideFriction, .gravity = kGravity};
    const Real exact = slideBlock({0, kSlideSpeed}, level, time_).position;
    const Quaternion& q = last_.orientation;
    return {{"stop [m]", last_.position.x() - x0_ - exact},
            {"drift [m]", drift_},
            {"yaw [rad]", 2 * std::atan2(q.z, q.w)},
            {"speed left [m/s]", last_.velocity.norm()}};
  }

 private:
  Real x0_, drift_ = 0, time_ = 0;
  State last_;
};

// --- C

constexpr Real kRollSpeed = 5, kRollFriction = 0.3, kRollRadius = 0.5;

class RollJudge : public Judge {
 public:
  void see(Real time, std::span<const State> bodies) override {
    const State& ball = bodies[1];
    const Real slip = ball.velocity.x() - ball.angularVelocity.y() * kRollRadius;
    // From the last look at which it slid on, at the rate of Coulomb's friction.
    if (slip > 1e-3) rolls_ = time + slip / (3.5 * kRollFriction * kGravity);
    last_ = ball, time_ = time;
  }
  std::vector<Figure> figures() const override {
    const TableBall start{{0, 0}, {kRollSpeed, 0}, Vector3::Zero()};
    const TableLaw law{.radius = kRollRadius, .friction = kRollFriction, .gravity = kGravity};
    const TableBall exact = rollBall(start, law, time_);
    return {{"speed [m/s]", last_.velocity.x() - exact.velocity.x()},
            {"roll time [s]", rolls_ - timeToRoll(start, law)},
            {"position [m]", last_.position.x() - exact.position.x()}};
  }

 private:
  State last_;
  Real time_ = 0, rolls_ = 0;
};

// --- F

class RotorJudge : public Judge {
 public:
  explicit RotorJudge(const Scene& scene)
      : scene_(scene),
        energy_(kineticEnergy(scene, startOf(scene))),
        momentum_(angularMomentum(scene, startOf(scene)).total),
        exact_(scene.bodies[0].moments,
               {scene.bodies[0].start.orientation, scene.bodies[0].start.angularVelocity}) {}
  void see(Real time, std::span<const State> bodies) override {
    const Vector3 now = angularMomentum(scene_, bodies).total;
    energyError_ = std::max(energyError_, std::abs(kineticEnergy(scene_, bodies) / energy_ - 1));
    sizeError_ = std::max(sizeError_, std::abs(now.norm() / momentum_.norm() - 1));
    const Vector3 across = now / now.norm() - momentum_ / momentum_.norm();
    turned_ = std::max(turned_, across.norm());
    for (std::size_t i = 0; i < kTimes.size(); ++i) {
      if (std::abs(time - kTimes[i]) < 1e-6) errors_[i] = attitudeError(time, bodies[0]);
    }
  }
  std::vector<Figure> figures() const override {
    return {{"orientation 1 s [rad]", errors_[0]},   {"orientation 10 s [rad]", errors_[1]},
            {"orientation 100 s [rad]", errors_[2]}, {"energy [1]", energyError_},
            {"angular momentum [1]", sizeError_},    {"direction of L [rad]", turned_}};
  }

 private:
  Real attitudeError(Real time, const State& body) const {
    const Quaternion between = hamiltonProduct(conjugate(exact_.at(time).q_WB), body.orientation);
    const Real sine =
        std::sqrt(between.x * between.x + between.y * between.y + between.z * between.z);
    return 2 * std::atan2(sine, std::abs(between.w));
  }

  static constexpr std::array<Real, 3> kTimes{1, 10, 100};
  Scene scene_;
  Real energy_;
  Vector3 momentum_;
  FreeRotor exact_;
  std::array<Real, 3> errors_{};
  Real energyError_ = 0, sizeError_ = 0, turned_ = 0;
};

// --- I8

constexpr Real kSlopeFriction = 0.5;

class InclineJudge : public Judge {
 public:
  explicit InclineJudge(Real angle) : angle_(angle) {}
  void see(Real time, std::span<const State> bodies) override {
    last_ = bodies[1], time_ = time;
  }
  std::vector<Figure> figures() const override {
    const Slope slope{.angle = angle_, .friction = kSlopeFriction, .gravity = kGravity};
    const Real exact = slideBlock({0, 0}, slope, time_).position;
    const Real error = last_.position.x() - exact;
    std::vector<Figure> all{{"way [m]", error}, {"drift [m]", std::abs(last_.position.y())}};
    if (exact > 0) all.push_back({"way, relative [1]", error / exact});
    return all;
  }

 private:
  Real angle_, time_ = 0;
  State last_;
};

// --- I15

class MasseJudge : public Judge {
 public:
  explicit MasseJudge(const State& start)
      : start_{start.position.head<2>(), start.velocity.head<2>(), start.angularVelocity} {}
  void see(Real time, std::span<const State> bodies) override {
    const TableBall exact = rollBall(start_, {.radius = 1, .friction = 0.2}, time);
    position_ = (bodies[1].position.head<2>() - exact.position).norm();
    velocity_ = (bodies[1].velocity.head<2>() - exact.velocity).norm();
    worst_ = std::max(worst_, position_);
  }
  std::vector<Figure> figures() const override {
    return {{"position [m]", position_}, {"velocity [m/s]", velocity_}, {"worst [m]", worst_}};
  }

 private:
  TableBall start_;
  Real position_ = 0, velocity_ = 0, worst_ = 0;
};

Scene onFloor(const std::string& name, const std::string& title, Body body) {
  Scene scene;
  scene.name = name, scene.title = title;
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero()), std::move(body)};
  return scene;
}

}  // namespace

Scene bounceScene() {
  Body ball = ballBody(BounceJudge::kRadius, 1);
  ball.start.position = {0, 0, BounceJudge::kRadius + BounceJudge::kDrop};
  ball.restitution = BounceJudge::kRestitution;
  ball.friction = 0;
  Scene scene = onFloor("A_bounce", "a ball bounces, e = 0.8, until it lies still", ball);
  scene.duration = 10, scene.bounces = true;
  scene.judge = [](const Scene&) { return std::make_unique<BounceJudge>(); };
  return scene;
}

Scene slideScene(const std::string& name, Real x0) {
  Body box = boxBody(Vector3::Constant(0.5), 1);
  box.start.position = {x0, 0, 0.5};
  box.start.velocity = {kSlideSpeed, 0, 0};
  box.friction = kSlideFriction;
  box.restitution = 0;
  Scene scene = onFloor(name, "a cube slides to rest", box);
  scene.middle = {x0, 0, 0};
  scene.duration = 2;
  scene.judge = [x0](const Scene&) { return std::make_unique<SlideJudge>(x0); };
  return scene;
}

Scene rollScene() {
  Body ball = ballBody(kRollRadius, 1);
  ball.start.position = {0, 0, kRollRadius};
  ball.start.velocity = {kRollSpeed, 0, 0};
  ball.friction = kRollFriction;
  ball.restitution = 0;
  Scene scene = onFloor("C_roll", "a ball slides and begins to roll", ball);
  scene.duration = 5;
  scene.judge = [](const Scene&) { return std::make_unique<RollJudge>(); };
  return scene;
}

Scene rotorScene() {
  Scene scene;
  scene.name = "F_rotor", scene.title = "a box tumbles about its middle axis";
  scene.gravity = Vector3::Zero();
  scene.bodies = {boxBody({0.5, 1, 1.5}, 6)};
  scene.bodies[0].start.angularVelocity = {0.01, 5, 0.01};
  scene.duration = 100, scene.lookEvery = 1.0 / 30;
  scene.judge = [](const Scene& s) { return std::make_unique<RotorJudge>(s); };
  return scene;
}

Scene inclineScene(const std::string& name, Real beyond) {
  const Real angle = std::atan(kSlopeFriction) + beyond;
  Body box = boxBody(Vector3::Constant(0.5), 1);
  box.start.position = {0, 0, 0.5};
  box.friction = kSlopeFriction;
  box.restitution = 0;
  Scene scene = onFloor(name, "a block on a slope; the slope is level, gravity is not", box);
  scene.gravity = kGravity * Vector3(std::sin(angle), 0, -std::cos(angle));
  scene.duration = 10;
  scene.judge = [angle](const Scene&) { return std::make_unique<InclineJudge>(angle); };
  return scene;
}

Scene masseScene() {
  Body ball = ballBody(1, 1);
  ball.start.position = {0, 0, 1};
  ball.start.velocity = {2, 0, 0};
  ball.start.angularVelocity = {-30, 10, 0};
  ball.friction = 0.2;
  ball.restitution = 0;
  Scene scene = onFloor("I15_masse", "a ball with side spin runs along a parabola", ball);
  scene.duration = 5, scene.reach = 40;
  scene.judge = [](const Scene& s) { return std::make_unique<MasseJudge>(s.bodies[1].start); };
  return scene;
}

}  // namespace carom::scenes
