// Balls: chains of impacts, gases, heaps.

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/core/random.hpp"
#include "carom/impulse/bouncing_ball.hpp"
#include "scenes/exact.hpp"
#include "scenes/families.hpp"
#include "scenes/overlaps.hpp"

namespace carom::scenes {
namespace {

// The generator of the case book: a 64-bit linear congruence, of which the top 31 bits count.
struct Congruence {
  std::uint64_t state;
  long next() {
    state = 6364136223846793005u * state + 1442695040888963407u;
    return static_cast<long>(state >> 33);
  }
};

// Potential and kinetic energy.
Real energyOf(const Scene& scene, std::span<const State> bodies) {
  Real sum = kineticEnergy(scene, bodies);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (body.moves) sum -= body.mass * scene.gravity.dot(bodies[i].position);
  }
  return sum;
}

// What hard balls do from the start of a scene: positions and velocities of the bodies that move.
std::vector<HardBall> hardBallsOf(const Scene& scene) {
  std::vector<HardBall> balls;
  for (const Body& body : scene.bodies) {
    if (!body.moves) continue;
    HardBall ball{{}, {}, std::get<Ball>(body.shape).radius, body.mass};
    for (std::size_t k = 0; k < 3; ++k) {
      ball.x[k] = body.start.position[static_cast<int>(k)];
      ball.v[k] = body.start.velocity[static_cast<int>(k)];
    }
    balls.push_back(ball);
  }
  return balls;
}

constexpr long double kFar = std::numeric_limits<long double>::infinity();
const HardRoom kOpen{{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}};

// Positions and velocities at the end beside those of the balls that go from impact to impact.
class ImpactsJudge : public Judge {
 public:
  ImpactsJudge(const Scene& scene, const HardRoom& room, std::vector<Real> moments)
      : scene_(scene),
        balls_(hardBallsOf(scene)),
        room_(room),
        moments_(std::move(moments)),
        energy_(energyOf(scene, startOf(scene))) {}
  void see(Real time, std::span<const State> bodies) override {
    energyError_ = energyOf(scene_, bodies) / energy_ - 1;
    for (const Real moment : moments_) {
      if (std::abs(time - moment) > 1e-6) continue;
      hardBalls(balls_, room_, static_cast<long double>(moment) - now_);
      now_ = moment;
      compare(moment, bodies);
    }
  }
  std::vector<Figure> figures() const override {
    std::vector<Figure> all = found_;
    all.push_back({"energy [1]", energyError_});
    return all;
  }

 private:
  void compare(Real moment, std::span<const State> bodies) {
    Real position = 0, velocity = 0;
    std::size_t ball = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!scene_.bodies[i].moves) continue;
      const HardBall& exact = balls_[ball++];
      for (std::size_t k = 0; k < 3; ++k) {
        const int axis = static_cast<int>(k);
        position =
            std::max(position, std::abs(static_cast<Real>(bodies[i].position[axis] - exact.x[k])));
        velocity =
            std::max(velocity, std::abs(static_cast<Real>(bodies[i].velocity[axis] - exact.v[k])));
      }
    }
    const std::string when =
        moments_.size() == 1 ? "" : " " + std::to_string(moment).substr(0, 3) + " s";
    found_.push_back({"position" + when + " [m]", position});
    found_.push_back({"velocity" + when + " [m/s]", velocity});
  }

  Scene scene_;
  std::vector<HardBall> balls_;
  HardRoom room_;
  std::vector<Real> moments_;
  Real energy_;
  long double now_ = 0;
  Real energyError_ = 0;
  std::vector<Figure> found_;
};

// Energy all the time, momentum at the end, and how deep the balls are in each other.
class EnergyJudge : public Judge {
 public:
  explicit EnergyJudge(const Scene& scene)
      : scene_(scene),
        energy_(energyOf(scene, startOf(scene))),
        momentum_(momentum(scene, startOf(scene))),
        angular_(angularMomentum(scene, startOf(scene))) {}
  void see(Real, std::span<const State> bodies) override {
    const Real error = energyOf(scene_, bodies) - energy_;
    squares_ += error * error, ++count_;
    end_ = error / energy_;
    deepest_ = std::max(deepest_, overlapsOf(scene_, bodies).deepest);
    const Vector3 p = momentum(scene_, bodies).total - momentum_.total;
    const Vector3 l = angularMomentum(scene_, bodies).total - angular_.total;
    momentumError_ = p.norm() / momentum_.size, angularError_ = l.norm() / angular_.size;
  }
  std::vector<Figure> figures() const override {
    const Real mean = squares_ / static_cast<Real>(count_);
    std::vector<Figure> all{{"energy at the end [1]", end_},
                            {"energy rms [1]", std::sqrt(mean) / energy_},
                            {"mean square energy [J^2]", mean},
                            {"deepest [m]", deepest_}};
    if (scene_.bodies[0].moves) {
      all.push_back({"momentum [1]", momentumError_});
      all.push_back({"angular momentum [1]", angularError_});
    }
    return all;
  }

 private:
  Scene scene_;
  Real energy_, squares_ = 0, end_ = 0, deepest_ = 0, momentumError_ = 0, angularError_ = 0;
  Momentum momentum_, angular_;
  long count_ = 0;
};

// --- S2

class Bouncing49Judge : public Judge {
 public:
  explicit Bouncing49Judge(const Scene& scene)
      : scene_(scene), energy_(energyOf(scene, startOf(scene))) {}
  void see(Real time, std::span<const State> bodies) override {
    const Real error = energyOf(scene_, bodies) - energy_;
    squares_ += error * error, ++count_;
    const Real exact =
        kRadius +
        bounceBall({kDrop - kRadius, 0}, {.restitution = 1, .gravity = 9.81}, time).height;
    height_ = 0;
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      height_ = std::max(height_, std::abs(bodies[i].position.z() - exact));
    }
  }
  std::vector<Figure> figures() const override {
    const Real mean = squares_ / static_cast<Real>(count_);
    return {{"mean square energy [J^2]", mean},
            {"energy rms [1]", std::sqrt(mean) / energy_},
            {"height at the end [m]", height_}};
  }
  static constexpr Real kRadius = 0.1, kDrop = 5;

 private:
  Scene scene_;
  Real energy_, squares_ = 0, height_ = 0;
  long count_ = 0;
};

// --- I14

constexpr Real kPush = 150;  // [N]

class PushedBoxJudge : public Judge {
 public:
  void see(Real time, std::span<const State> bodies) override {
    // 10 a1 = F - mu (M + n m) g - n f2, f2 = m a2 with a1 = 7/2 a2 (the balls roll without
    // slipping): case I14.
    const Real a2 = (kPush - 0.4 * 35 * 9.81) / (35 + 25), a1 = 3.5 * a2;
    const Vector3 direction = bodiesDirection();
    Real worst = (bodies[1].velocity - a1 * time * direction).norm();
    box_ = worst;
    Real sum = worst * worst;
    for (std::size_t i = 2; i < bodies.size(); ++i) {
      ball_ = (bodies[i].velocity - a2 * time * direction).norm();
      sum += ball_ * ball_ / 25;
    }
    squares_ += sum, ++count_;
    way_ = (bodies[1].position - Vector3(0, 0, 0.2) - a1 * time * time / 2 * direction).norm();
  }
  std::vector<Figure> figures() const override {
    return {{"mean square velocity [m^2/s^2]", squares_ / static_cast<Real>(count_)},
            {"box velocity [m/s]", box_},
            {"ball velocity [m/s]", ball_},
            {"box position [m]", way_}};
  }
  static Vector3 bodiesDirection() {
    return {0.5, std::sqrt(3.0) / 2, 0};
  }

 private:
  Real squares_ = 0, box_ = 0, ball_ = 0, way_ = 0;
  long count_ = 0;
};

Body elasticBall(Real radius, Real mass, const Vector3& position) {
  Body ball = ballBody(radius, mass);
  ball.friction = 0;
  ball.restitution = 1;
  ball.start.position = position;
  return ball;
}

// 666 places of a grid of 9 x 9 columns, each moved a little.
std::vector<Vector3> jitteredGrid(Real spacing, const Vector3& low) {
  Random random(666);
  std::vector<Vector3> places;
  for (int i = 0; places.size() < 666; ++i) {
    const Vector3 cell(i % 9, (i / 9) % 9, i / 81);
    places.push_back(low + spacing * cell + random.vector(0.01));
  }
  return places;
}

}  // namespace

Scene cradleScene(const std::string& name, int moving) {
  constexpr Real kRadius = 0.5, kSpeed = 2;
  Scene scene;
  scene.name = name, scene.title = "touching balls in a row, of which the first come in";
  scene.gravity = Vector3::Zero();
  scene.bounces = true;
  for (int i = 0; i < 5; ++i) {
    // The gap of 0.97 m is not crossed at the end of a step.
    const Real x = i < moving ? i - 0.97 : i;
    scene.bodies.push_back(elasticBall(kRadius, 1, {x, 0, 0}));
    if (i < moving) scene.bodies.back().start.velocity = {kSpeed, 0, 0};
  }
  scene.duration = 1;
  scene.judge = [](const Scene& s) {
    return std::make_unique<ImpactsJudge>(s, kOpen, std::vector<Real>{s.duration});
  };
  return scene;
}

Scene twoBallsScene(const std::string& name, Real ratio) {
  constexpr Real kBig = 0.1, kSmall = 0.03, kDrop = 1, kGap = 1e-4;
  Scene scene;
  scene.name = name, scene.title = "a small ball just above a big one, dropped together";
  scene.bounces = true;
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero()),
                  elasticBall(kBig, ratio, {0, 0, kBig + kDrop}),
                  elasticBall(kSmall, 1, {0, 0, 2 * kBig + kDrop + kGap + kSmall})};
  scene.duration = 0.9;
  scene.judge = [](const Scene& s) {
    HardRoom room = kOpen;
    room.low[2] = 0;
    room.gravity = 9.81L;
    return std::make_unique<ImpactsJudge>(s, room, std::vector<Real>{s.duration});
  };
  return scene;
}

Scene obliqueScene() {
  constexpr Real kRadius = 1, kAside = 0.7 * 2 * kRadius, kSpeed = 5;
  Scene scene;
  scene.name = "I13_oblique", scene.title = "a ball hits another off the line of centres";
  scene.gravity = Vector3::Zero();
  scene.bounces = true;
  scene.bodies = {elasticBall(kRadius, 1, {0, 0, 0}), elasticBall(kRadius, 1, {-4.3, kAside, 0})};
  scene.bodies[1].start.velocity = {kSpeed, 0, 0};
  scene.duration = 1;
  scene.judge = [](const Scene& s) {
    return std::make_unique<ImpactsJudge>(s, kOpen, std::vector<Real>{s.duration});
  };
  return scene;
}

Scene breakScene(const std::string& name, int power) {
  constexpr Real kRadius = 0.5;
  Scene scene;
  scene.name = name, scene.title = "a heavy ball pushes a light one against a wall";
  scene.gravity = Vector3::Zero();
  scene.bounces = true;
  scene.bodies = {planeBody(Vector3::UnitX(), Vector3::Zero()), elasticBall(kRadius, 1, {2, 0, 0}),
                  elasticBall(kRadius, std::pow(100, power), {4, 0, 0})};
  scene.bodies[2].start.velocity = {-1, 0, 0};
  scene.duration = 6;
  scene.judge = [](const Scene& s) {
    HardRoom room = kOpen;
    room.low[0] = 0;
    return std::make_unique<ImpactsJudge>(s, room, std::vector<Real>{s.duration});
  };
  return scene;
}

Scene gasScene() {
  Scene scene;
  scene.name = "S8_gas", scene.title = "eight hard balls in a unit box";
  scene.gravity = Vector3::Zero();
  scene.bounces = true;
  scene.bodies = room(Vector3::Zero(), Vector3::Ones());
  Congruence numbers{3};
  for (int cell = 0; cell < 8; ++cell) {
    const std::array<int, 3> place{cell / 4, cell / 2 % 2, cell % 2};
    Vector3 position, velocity;
    for (int k = 0; k < 3; ++k) {
      const auto shift = static_cast<Real>(numbers.next() % 1001 - 500);
      position[k] = (2.0 * place[static_cast<std::size_t>(k)] + 1) / 4 + shift / 20000;
    }
    for (int k = 0; k < 3; ++k) {
      velocity[k] = static_cast<Real>(numbers.next() % 2001 - 1000) / 1000;
    }
    scene.bodies.push_back(elasticBall(0.1, 1, position));
    scene.bodies.back().start.velocity = velocity;
  }
  scene.duration = 8;
  scene.judge = [](const Scene& s) {
    const HardRoom unit{{0, 0, 0}, {1, 1, 1}};
    return std::make_unique<ImpactsJudge>(s, unit, std::vector<Real>{0.5, 1, 2});
  };
  return scene;
}

Scene bouncing49Scene() {
  Scene scene;
  scene.name = "S2_bouncing", scene.title = "49 balls bounce without loss for 20 s";
  scene.bounces = true;
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero())};
  for (int i = 0; i < 49; ++i) {
    const Vector3 place(i % 7 - 3, i / 7 - 3, Bouncing49Judge::kDrop);
    scene.bodies.push_back(elasticBall(Bouncing49Judge::kRadius, 10, place));
  }
  scene.duration = 20;
  scene.judge = [](const Scene& s) { return std::make_unique<Bouncing49Judge>(s); };
  return scene;
}

Scene balls216Scene(const std::string& name, bool elastic) {
  Scene scene;
  scene.name = name;
  scene.title = elastic ? "216 balls, e = 1: energy" : "216 balls, e = 0: penetration";
  scene.bounces = elastic;
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero())};
  Congruence numbers{42};
  const Real lift = elastic ? 1.101 : 0.101;
  for (int cell = 0; cell < 216; ++cell) {
    const std::array<int, 3> place{cell / 36, cell / 6 % 6, cell % 6};
    Vector3 position;
    for (int k = 0; k < 3; ++k) {
      const Real u = static_cast<Real>(numbers.next()) * 0x1p-31;
      position[k] = 0.21 * place[static_cast<std::size_t>(k)] + 0.001 * u + (k == 2 ? lift : 0);
    }
    scene.bodies.push_back(elasticBall(0.1, 10, position));
    scene.bodies.back().restitution = elastic ? 1 : 0;
  }
  scene.duration = 10, scene.lookEvery = 1.0 / 30, scene.reach = 100;
  if (elastic) {
    scene.judge = [](const Scene& s) { return std::make_unique<EnergyJudge>(s); };
  } else {
    scene.judge = depthJudge;
  }
  return scene;
}

Scene drop666Scene() {
  Scene scene;
  scene.name = "D_drop666", scene.title = "666 balls fall on a floor";
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero())};
  for (const Vector3& place : jitteredGrid(0.25, {-1, -1, 0.5})) {
    Body ball = ballBody(0.1, 1);
    ball.friction = 1 / std::sqrt(2.0);  // 0.5 between balls, 0.71 on the floor
    ball.restitution = 0;
    ball.start.position = place;
    scene.bodies.push_back(ball);
  }
  scene.duration = 5, scene.lookEvery = 1.0 / 30;
  scene.judge = depthJudge;
  return scene;
}

Scene elastic666Scene(const std::string& name, bool walls) {
  Scene scene;
  scene.name = name;
  scene.title = walls ? "666 elastic balls in a room" : "666 elastic balls that fly apart";
  scene.gravity = Vector3::Zero();
  scene.bounces = true;
  Random random(6);
  for (const Vector3& place : jitteredGrid(0.5, Vector3::Constant(-2.2))) {
    scene.bodies.push_back(elasticBall(0.1, 1, place));
    // Free balls that flew apart at once would not meet: theirs move to the middle as well.
    Vector3 velocity = random.vector(3);
    if (!walls) velocity -= 0.5 * place;
    scene.bodies.back().start.velocity = velocity;
  }
  if (walls) {
    const std::vector<Body> around = room(Vector3::Constant(-3), Vector3::Constant(3));
    scene.bodies.insert(scene.bodies.begin(), around.begin(), around.end());
  }
  scene.duration = walls ? 10 : 3;
  scene.lookEvery = 1.0 / 30;
  scene.judge = [](const Scene& s) { return std::make_unique<EnergyJudge>(s); };
  return scene;
}

Scene pushedBoxScene() {
  Scene scene;
  scene.name = "I14_pushed", scene.title = "25 balls on a box that is pushed, not along an axis";
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero()), boxBody({2, 2, 0.2}, 10)};
  scene.bodies[0].friction = 0.4;
  scene.bodies[1].start.position = {0, 0, 0.2};
  scene.bodies[1].restitution = 0;
  scene.bodies[1].force = kPush * PushedBoxJudge::bodiesDirection();
  for (int i = 0; i < 25; ++i) {
    Body ball = ballBody(0.1, 1);
    ball.friction = 0.8, ball.restitution = 0;
    ball.start.position = {0.3 * (i % 5 - 2), 0.3 * (i / 5 - 2), 0.5};
    scene.bodies.push_back(ball);
  }
  scene.duration = 0.9;
  scene.judge = [](const Scene&) { return std::make_unique<PushedBoxJudge>(); };
  return scene;
}

}  // namespace carom::scenes
