// Boxes on boxes, balls at a wall, polyhedra in a bin.

#include <algorithm>
#include <cmath>

#include "carom/core/random.hpp"
#include "scenes/families.hpp"
#include "scenes/overlaps.hpp"

namespace carom::scenes {
namespace {

const Real kHalfFriction = std::sqrt(0.5);  // 0.5 between two bodies that have it

// Whether what stood still stands, and how far it went.
class StandJudge : public Judge {
 public:
  explicit StandJudge(const Scene& scene) : scene_(scene) {}
  void see(Real, std::span<const State> bodies) override {
    const Overlaps overlaps = overlapsOf(scene_, bodies);
    deepest_ = std::max(deepest_, overlaps.deepest);
    mean_ = overlaps.mean;
    speed_ = sunk_ = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!scene_.bodies[i].moves) continue;
      const Vector3 way = bodies[i].position - scene_.bodies[i].start.position;
      drift_ = std::max(drift_, std::hypot(way.x(), way.y()));
      sunk_ = std::max(sunk_, -way.z());
      speed_ = std::max(speed_, bodies[i].velocity.norm());
    }
    lowest_ = std::max(lowest_, sunk_);
  }
  std::vector<Figure> figures() const override {
    return {{"stands [1]", lowest_ < 0.5 && drift_ < 0.5 ? 1.0 : 0.0},
            {"deepest [m]", deepest_},
            {"mean depth at the end [m]", mean_},
            {"drift [m]", drift_},
            {"sunk at the end [m]", sunk_},
            {"speed left [m/s]", speed_}};
  }

 private:
  Scene scene_;
  Real deepest_ = 0, mean_ = 0, drift_ = 0, sunk_ = 0, lowest_ = 0, speed_ = 0;
};

// --- J

constexpr Real kWall = 0.02, kBulletRadius = 0.05;  // [m]

class BulletJudge : public Judge {
 public:
  void see(Real, std::span<const State> bodies) override {
    through_ = inside_ = 0;
    deepest_ = 0;
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      const Real gap = bodies[i].position.z() - kWall / 2 - kBulletRadius;
      if (bodies[i].position.z() < 0) {
        ++through_;
      } else {
        if (gap < -1e-9) ++inside_;
        deepest_ = std::max(deepest_, -gap);
      }
    }
  }
  std::vector<Figure> figures() const override {
    return {{"through the wall [1]", static_cast<Real>(through_)},
            {"inside it [1]", static_cast<Real>(inside_)},
            {"deepest [m]", deepest_}};
  }

 private:
  int through_ = 0, inside_ = 0;
  Real deepest_ = 0;
};

Body restingBox(Real mass, const Vector3& position) {
  Body box = boxBody(Vector3::Constant(0.5), mass);
  box.friction = kHalfFriction;
  box.restitution = 0;
  box.start.position = position;
  return box;
}

Scene standing(const std::string& name, const std::string& title) {
  Scene scene;
  scene.name = name, scene.title = title;
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero())};
  scene.bodies[0].friction = kHalfFriction;
  scene.duration = 10, scene.lookEvery = 0.1, scene.tall = true;
  scene.judge = [](const Scene& s) { return std::make_unique<StandJudge>(s); };
  return scene;
}

}  // namespace

Scene stackScene(const std::string& name, int count, Real x0) {
  Scene scene = standing(name, "cubes of a tonne on each other");
  scene.middle = {x0, 0, 0};
  scene.reach = 60;
  for (int i = 0; i < count; ++i) scene.bodies.push_back(restingBox(1000, {x0, 0, i + 0.5}));
  return scene;
}

Scene pyramidScene(const std::string& name, int base) {
  Scene scene = standing(name, "a wall of cubes in the shape of a triangle");
  scene.reach = 120;
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      const Real x = 1.1 * (i - 0.5 * (base - row - 1));
      scene.bodies.push_back(restingBox(1000, {x, 0, row + 0.5}));
    }
  }
  scene.duration = 5, scene.lookEvery = 0.5;
  return scene;
}

Scene massRatioScene(const std::string& name, const std::vector<Real>& masses) {
  Scene scene = standing(name, "cubes of unlike masses on each other");
  for (std::size_t i = 0; i < masses.size(); ++i) {
    scene.bodies.push_back(restingBox(masses[i], {0, 0, static_cast<Real>(i) + 0.5}));
  }
  return scene;
}

Scene bulletScene(const std::string& name, Real speed) {
  Scene scene;
  scene.name = name, scene.title = "1000 balls are shot at a thin wall";
  scene.gravity = Vector3::Zero();
  scene.fast = true, scene.strangers = true, scene.reach = 1000;
  Body wall = boxBody({800, 800, kWall / 2}, 1);
  wall.moves = false;
  scene.bodies = {wall};
  Random random(7);
  while (scene.bodies.size() <= 1000) {
    const Vector3 direction = random.direction();
    if (direction.z() > -0.5) continue;  // up to 60 degrees off the normal
    // It meets the wall somewhere in the third or fourth step of 1/60 s.
    const Real time = random.between(2, 4) / 60;
    const Real x = random.between(-50, 50);
    const Real y = random.between(-50, 50);
    Body ball = ballBody(kBulletRadius, 1);
    ball.friction = 0.5, ball.restitution = 0.5;
    ball.start.velocity = speed * direction;
    ball.start.position = Vector3(x, y, kWall / 2 + kBulletRadius) - time * ball.start.velocity;
    scene.bodies.push_back(ball);
  }
  scene.duration = 10.0 / 60;
  scene.judge = [](const Scene&) { return std::make_unique<BulletJudge>(); };
  return scene;
}

Scene fieldScene(const std::string& name, bool asleep) {
  Scene scene;
  scene.name = name;
  scene.title = asleep ? "5000 boxes asleep" : "5000 boxes at rest, awake";
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero())};
  scene.bodies[0].friction = kHalfFriction;
  for (int i = 0; i < 5000; ++i) {
    scene.bodies.push_back(restingBox(1000, {2.0 * (i % 71 - 35), 2.0 * (i / 71 - 35), 0.5}));
  }
  scene.sleeps = asleep, scene.reach = 200;
  scene.untimed = asleep ? 4 : 1;
  scene.duration = scene.untimed + (asleep ? 10 : 1);
  scene.lookEvery = scene.duration;
  scene.judge = depthJudge;
  return scene;
}

Scene hullPileScene() {
  Scene scene;
  scene.name = "L_hulls", scene.title = "1000 polyhedra fall into a bin of 8 x 8 m";
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero()),
                  planeBody(Vector3::UnitX(), {-4, 0, 0}), planeBody(-Vector3::UnitX(), {4, 0, 0}),
                  planeBody(Vector3::UnitY(), {0, -4, 0}), planeBody(-Vector3::UnitY(), {0, 4, 0})};
  for (Body& wall : scene.bodies) wall.friction = kHalfFriction;
  Random random(1000);
  for (int i = 0; i < 1000; ++i) {
    const Real a = random.between(0.2, 0.4);
    const Real b = random.between(0.2, 0.4);
    const Real c = random.between(0.2, 0.4);
    std::vector<Vector3> points;
    for (int k = 0; k < 20; ++k)
      points.push_back(random.direction().cwiseProduct(Vector3(a, b, c)));
    Body hull = hullBody(points, kDensity);
    hull.friction = kHalfFriction, hull.restitution = 0;
    const Vector3 cell(i % 9 - 4, i / 9 % 9 - 4, i / 81);
    hull.start.position = Vector3(0, 0, 0.5) + 0.85 * cell;
    scene.bodies.push_back(hull);
  }
  scene.duration = 5, scene.lookEvery = 0.25;
  scene.judge = depthJudge;
  return scene;
}

namespace {

// What Box3D gives to every shape that says nothing else.
const Real kItsFriction = std::sqrt(0.6);

Scene itsScene(const std::string& name, const std::string& title, Real reach, int steps) {
  Scene scene;
  scene.name = name, scene.title = title;
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero())};
  scene.bodies[0].friction = kItsFriction;
  scene.reach = reach;
  scene.duration = steps / 60.0, scene.lookEvery = scene.duration;
  return scene;
}

// Unit cubes of 100 kg in the shape of a triangle, edge to edge; the lowest one is at `first`.
void addTriangle(Scene& scene, int base, const Vector3& first) {
  Body cube = boxBody(Vector3::Constant(0.5), 100);
  cube.friction = kItsFriction, cube.restitution = 0;
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      cube.start.position = first + Vector3(i + 0.5 * row, 0, row);
      scene.bodies.push_back(cube);
    }
  }
}

}  // namespace

Scene largePyramidScene() {
  Scene scene = itsScene("P_large_pyramid", "5050 cubes in the shape of a triangle", 400, 200);
  addTriangle(scene, 100, {-49.5, 0, 0.5});
  scene.tall = true;
  scene.judge = [](const Scene& s) { return std::make_unique<StandJudge>(s); };
  return scene;
}

Scene manyPyramidsScene() {
  constexpr int kBase = 10, kSide = 14;
  constexpr Real kHalf = 0.5 * kSide * (kBase + 1);  // of the ground's edge [m]
  Scene scene = itsScene("P_many_pyramids", "196 triangles of 55 cubes", kHalf, 100);
  for (int i = 0; i < kSide; ++i) {
    const Real y = -kHalf + 1 + i * 2 * (kHalf - 1) / (kSide - 1);
    for (int j = 0; j < kSide; ++j) addTriangle(scene, kBase, {-kHalf + 11.0 * j + 1, y, 0.5});
  }
  scene.judge = [](const Scene& s) { return std::make_unique<StandJudge>(s); };
  return scene;
}

Scene convexPileScene() {
  constexpr Real kRadius = 2;  // of the ball on which the corners lie [m]
  Scene scene = itsScene("P_convex_pile", "80 layers of 64 polyhedra of 32 corners", 250, 500);
  Random random(42);
  std::vector<Vector3> corners;
  for (int i = 0; i < 32; ++i) corners.push_back(kRadius * random.direction());
  Body hull = hullBody(corners, kDensity);
  hull.friction = kItsFriction, hull.restitution = 0;
  for (int i = 0; i < 80 * 64; ++i) {
    hull.start.position =
        2 * kRadius * Vector3(i % 8 - 4, i / 8 % 8 - 4, i / 64) + Vector3(0, 0, kRadius);
    scene.bodies.push_back(hull);
  }
  scene.judge = depthJudge;
  return scene;
}

std::vector<SceneEntry> allScenes() {
  std::vector<SceneEntry> all;
  const auto add = [&all](const std::string& name, auto make) {
    all.push_back({name, [name, make] { return make(name); }});
  };
  add("A_bounce", [](const auto&) { return bounceScene(); });
  add("B_slide", [](const auto& n) { return slideScene(n, 0); });
  add("C_roll", [](const auto&) { return rollScene(); });
  add("D_drop666", [](const auto&) { return drop666Scene(); });
  add("E_elastic666", [](const auto& n) { return elastic666Scene(n, true); });
  add("E2_free666", [](const auto& n) { return elastic666Scene(n, false); });
  add("F_rotor", [](const auto&) { return rotorScene(); });
  for (const int count : {10, 20, 40}) {
    add("G_stack" + std::to_string(count),
        [count](const auto& n) { return stackScene(n, count, 0); });
  }
  for (const int base : {30, 60}) {
    add("H_pyramid" + std::to_string(base),
        [base](const auto& n) { return pyramidScene(n, base); });
  }
  add("I_1000on1", [](const auto& n) { return massRatioScene(n, {1, 1000}); });
  add("I_10000on1", [](const auto& n) { return massRatioScene(n, {1, 10000}); });
  add("I_alternating", [](const auto& n) { return massRatioScene(n, {1, 100, 1, 100, 1, 100}); });
  for (const int speed : {50, 200, 350, 400, 600, 1000, 3000}) {
    add("J_bullet" + std::to_string(speed),
        [speed](const auto& n) { return bulletScene(n, speed); });
  }
  add("K_awake", [](const auto& n) { return fieldScene(n, false); });
  add("K_asleep", [](const auto& n) { return fieldScene(n, true); });
  add("L_hulls", [](const auto&) { return hullPileScene(); });
  add("P_large_pyramid", [](const auto&) { return largePyramidScene(); });
  add("P_many_pyramids", [](const auto&) { return manyPyramidsScene(); });
  add("P_convex_pile", [](const auto&) { return convexPileScene(); });
  add("M_slide_1e5", [](const auto& n) { return slideScene(n, 1e5); });
  add("M_slide_1e6", [](const auto& n) { return slideScene(n, 1e6); });
  add("M_stack10_1e6", [](const auto& n) { return stackScene(n, 10, 1e6); });
  add("S1_stack", [](const auto&) { return restingStackScene(); });
  add("S2_bouncing", [](const auto&) { return bouncing49Scene(); });
  add("S3_elastic", [](const auto& n) { return balls216Scene(n, true); });
  add("S3_inelastic", [](const auto& n) { return balls216Scene(n, false); });
  add("S4_10on1", [](const auto& n) { return heavyOnLightScene(n, 10); });
  add("S4_1000on1", [](const auto& n) { return heavyOnLightScene(n, 1000); });
  add("S4_1000000on1", [](const auto& n) { return heavyOnLightScene(n, 1e6); });
  add("S5_stands", [](const auto& n) { return cardHouseScene(n, 1e-6); });
  add("S5_slides", [](const auto& n) { return cardHouseScene(n, -1e-3); });
  add("S6_stands", [](const auto& n) { return archScene(n, 12, 1.02, 0.7); });
  add("S6_falls", [](const auto& n) { return archScene(n, 12, 0.98, 0.7); });
  add("S6_rough", [](const auto& n) { return archScene(n, 12, 1.02, 4); });
  add("S7_domino", [](const auto&) { return dominoScene(); });
  add("S8_gas", [](const auto&) { return gasScene(); });
  add("S9_ratio3", [](const auto& n) { return twoBallsScene(n, 3); });
  add("S9_ratio1000", [](const auto& n) { return twoBallsScene(n, 1000); });
  add("S10_rocking", [](const auto&) { return rockingScene(); });
  add("S11_pyramid", [](const auto&) { return smallPyramidScene(); });
  add("I5_cradle1", [](const auto& n) { return cradleScene(n, 1); });
  add("I5_cradle2", [](const auto& n) { return cradleScene(n, 2); });
  add("N10_top", [](const auto&) { return topScene(); });
  add("I13_oblique", [](const auto&) { return obliqueScene(); });
  add("I8_at", [](const auto& n) { return inclineScene(n, 0); });
  add("I8_below", [](const auto& n) { return inclineScene(n, -1e-6); });
  add("I8_above", [](const auto& n) { return inclineScene(n, 1e-6); });
  add("I8_steep", [](const auto& n) { return inclineScene(n, 1e-2); });
  add("I14_pushed", [](const auto&) { return pushedBoxScene(); });
  add("I15_masse", [](const auto&) { return masseScene(); });
  add("I19_corner", [](const auto&) { return cornerScene(); });
  add("T13_break31", [](const auto& n) { return breakScene(n, 1); });
  add("T13_break314", [](const auto& n) { return breakScene(n, 2); });
  return all;
}

}  // namespace carom::scenes
