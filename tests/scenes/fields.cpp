// Crowds for growth and skipping.

#include <algorithm>
#include <cmath>

#include "carom/core/random.hpp"
#include "scenes/families.hpp"

namespace carom::scenes {
namespace {

// The energy that is left, which says whether the crowd has come to rest.
class CrowdJudge : public Judge {
 public:
  explicit CrowdJudge(const Scene& scene) : scene_(scene) {}
  void see(Real, std::span<const State> bodies) override {
    energy_ = kineticEnergy(scene_, bodies);
  }
  std::vector<Figure> figures() const override {
    return {{"kinetic energy [J]", energy_}};
  }

 private:
  const Scene& scene_;  // large: the run keeps it
  Real energy_ = 0;
};

Scene crowd(const std::string& name, const std::string& title) {
  Scene scene;
  scene.name = name, scene.title = title;
  scene.duration = 1.25, scene.untimed = 1;
  scene.lookEvery = 1.0 / 12;
  scene.judge = [](const Scene& s) { return std::make_unique<CrowdJudge>(s); };
  return scene;
}

// Balls and boxes in turn.
Body crowdBody(int i, const Vector3& position) {
  Body body = i % 2 == 0 ? ballBody(0.25, 50) : boxBody(Vector3::Constant(0.25), 100);
  body.friction = std::sqrt(0.5), body.restitution = 0;
  body.start.position = position;
  return body;
}

int sideOf(int count) {
  return static_cast<int>(std::ceil(std::sqrt(count)));
}

}  // namespace

Scene spreadScene(int count) {
  Scene scene = crowd("spread_" + std::to_string(count), "bodies far from each other on a floor");
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero())};
  const int side = sideOf(count);
  for (int i = 0; i < count; ++i) {
    scene.bodies.push_back(crowdBody(i, {1.0 * (i % side), 1.0 * (i / side), 0.3}));
  }
  scene.middle = {side / 2.0, side / 2.0, 0};
  scene.reach = side + 20;
  return scene;
}

Scene pileScene(int count) {
  Scene scene = crowd("pile_" + std::to_string(count), "bodies in a heap ten layers high");
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero())};
  Random random(11);
  const int side = sideOf((count + 9) / 10);
  for (int i = 0; i < count; ++i) {
    const int layer = i / (side * side), cell = i % (side * side);
    const Vector3 place(0.55 * (cell % side), 0.55 * (cell / side), 0.27 + 0.53 * layer);
    const Real dx = random.between(-0.02, 0.02);
    const Real dy = random.between(-0.02, 0.02);
    scene.bodies.push_back(crowdBody(i, place + Vector3(dx, dy, 0)));
  }
  scene.middle = {0.28 * side, 0.28 * side, 0};
  scene.reach = side + 20;
  return scene;
}

const char* nameOf(Quiet kind) {
  switch (kind) {
    case Quiet::immovable:
      return "immovable";
    case Quiet::resting:
      return "resting";
    case Quiet::flying:
      return "flying";
    case Quiet::unturned:
      return "unturned";
    default:
      return "frictionless";
  }
}

Scene quietScene(Quiet kind, int count) {
  Scene scene = crowd(std::string(nameOf(kind)) + "_" + std::to_string(count),
                      "ten bodies that collide, beside a quiet crowd");
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero())};
  for (const Vector3& middle :
       {Vector3(-0.5, 1.5, 5), Vector3(3.5, 1.5, 5), Vector3(1.5, -0.5, 5), Vector3(1.5, 3.5, 5)}) {
    const bool alongX = middle.y() == 1.5;
    Body wall = boxBody(alongX ? Vector3(0.5, 3, 5) : Vector3(3, 0.5, 5), 1);
    wall.moves = false;
    wall.start.position = middle;
    scene.bodies.push_back(wall);
  }
  Random random(10);
  for (int i = 0; i < 10; ++i) {
    Body ball = ballBody(0.25, 1);
    ball.friction = 0, ball.restitution = 1;
    ball.start.position = {0.5 + i % 3, 0.5 + i / 3 % 3, 0.5 + i / 9};
    ball.start.velocity = random.vector(3);
    scene.bodies.push_back(ball);
  }
  const int side = sideOf(count);
  for (int i = 0; i < count; ++i) {
    const Vector3 place(20 + 2.0 * (i % side), 2.0 * (i / side), 0);
    Body body = boxBody(Vector3::Constant(0.25), 100);
    body.friction = std::sqrt(0.5), body.restitution = 0;
    body.start.position = place + Vector3(0, 0, 0.25);
    switch (kind) {
      case Quiet::immovable:
        body.moves = false;
        break;
      case Quiet::resting:
        break;
      case Quiet::flying:
        body.start.position.z() = 100;
        body.start.angularVelocity = {0.1, 1, 0.1};
        break;
      case Quiet::unturned:
        body = ballBody(0.25, 100);
        body.start.position = place + Vector3(0, 0, 100);
        break;
      case Quiet::frictionless:
        body = ballBody(0.25, 100);
        body.friction = 0, body.restitution = 0;
        body.start.position = place + Vector3(0, 0, 0.25);
        body.start.velocity = {0.1, 0, 0};
        break;
    }
    scene.bodies.push_back(body);
  }
  scene.middle = {side + 20.0, 1.0 * side, 0};
  scene.reach = 2.0 * side + 60;
  scene.sleeps = true, scene.bounces = true;
  return scene;
}

}  // namespace carom::scenes
