// What stands by itself, or just does not: towers, unlike masses, a card house, an arch, a pyramid.
//
// Whether they stand is decided by statics (exact.hpp), a hair's breadth above and below a limit.
// The judge looks at the corners of the bodies, and at nothing else.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "carom/core/elementary.hpp"
#include "carom/detection/pose.hpp"
#include "scenes/exact.hpp"
#include "scenes/families.hpp"
#include "scenes/overlaps.hpp"

namespace carom::scenes {
namespace {

const Real kHalfFriction = std::sqrt(0.5);  // 0.5 between two bodies that have it

// The corners of a solid with flat faces [m, body].
std::vector<Vector3> cornersOf(const Shape& shape) {
  if (const ConvexHull* hull = std::get_if<ConvexHull>(&shape)) return hull->vertices;
  std::vector<Vector3> corners;
  if (const Box* box = std::get_if<Box>(&shape)) {
    for (int i = 0; i < 8; ++i) {
      const Vector3 signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
      corners.push_back(box->halfExtents.cwiseProduct(signs));
    }
  }
  return corners;
}

// How far the corners of what should stand have gone.
class CornersJudge : public Judge {
 public:
  explicit CornersJudge(const Scene& scene) : scene_(scene) {
    for (const Body& body : scene.bodies) {
      corners_.push_back(body.moves ? cornersOf(body.shape) : std::vector<Vector3>());
    }
  }
  void see(Real, std::span<const State> bodies) override {
    now_ = speed_ = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Pose start = poseOfState(scene_.bodies[i].start), pose = poseOfState(bodies[i]);
      for (const Vector3& corner : corners_[i]) {
        now_ = std::max(now_, (pointToWorld(pose, corner) - pointToWorld(start, corner)).norm());
      }
      if (scene_.bodies[i].moves) speed_ = std::max(speed_, bodies[i].velocity.norm());
    }
    most_ = std::max(most_, now_);
    deepest_ = std::max(deepest_, overlapsOf(scene_, bodies).deepest);
  }
  std::vector<Figure> figures() const override {
    constexpr Real kFallen = 0.1;  // [m]
    return {{"stands [1]", most_ < kFallen ? 1.0 : 0.0},
            {"moves [m]", most_},
            {"moved at the end [m]", now_},
            {"deepest [m]", deepest_},
            {"speed left [m/s]", speed_}};
  }

 private:
  Scene scene_;
  std::vector<std::vector<Vector3>> corners_;  // of each body that moves [m, body]
  Real now_ = 0, most_ = 0, deepest_ = 0, speed_ = 0;
};

Scene standing(const std::string& name, const std::string& title, Real floorFriction) {
  Scene scene;
  scene.name = name, scene.title = title;
  scene.bodies = {planeBody(Vector3::UnitZ(), Vector3::Zero())};
  scene.bodies[0].friction = floorFriction;
  scene.duration = 10, scene.lookEvery = 0.1, scene.tall = true;
  scene.judge = [](const Scene& s) { return std::make_unique<CornersJudge>(s); };
  return scene;
}

Body unitCube(Real mass, const Vector3& position) {
  Body box = boxBody(Vector3::Constant(0.5), mass);
  box.friction = kHalfFriction, box.restitution = 0;
  box.start.position = position;
  return box;
}

// A prism along y.
Body prism(const std::vector<Vector3>& outline, Real halfDepth) {
  std::vector<Vector3> points;
  for (const Real y : {-halfDepth, halfDepth}) {
    for (const Vector3& corner : outline) points.push_back(corner + Vector3(0, y, 0));
  }
  Body body = placedHull(points, kDensity);
  body.restitution = 0;
  return body;
}

}  // namespace

Scene restingStackScene() {
  Scene scene =
      standing("S1_stack", "ten cubes of a kilogram for a thousand seconds", kHalfFriction);
  for (int i = 0; i < 10; ++i) scene.bodies.push_back(unitCube(1, {0, 0, i + 0.5}));
  scene.duration = 1000, scene.lookEvery = 10;
  return scene;
}

Scene heavyOnLightScene(const std::string& name, Real ratio) {
  Scene scene = standing(name, "a heavy cube on one of a kilogram", kHalfFriction);
  scene.bodies.push_back(unitCube(1, {0, 0, 0.5}));
  scene.bodies.push_back(unitCube(ratio, {0, 0, 1.5}));
  return scene;
}

Scene cardHouseScene(const std::string& name, Real above) {
  constexpr Real kAngle = 0.35;     // from the vertical [rad]
  constexpr Real kCut = 0.03;       // height of the faces that lean against each other [m]
  constexpr Real kHalfDepth = 0.3;  // [m]
  const Real s = sine(kAngle), c = cosine(kAngle);
  Scene scene = standing(name, "two cards lean against each other", 1);
  for (const Real side : {-1.0, 1.0}) {
    // Cut upright at both ends, so that they stand on an edge, and push each other sideways.
    // From the foot to the highest point of contact it is a metre, and the centre is half way.
    Body card =
        prism({{side * s, 0, 0}, {0, 0, c - kCut}, {0, 0, c}, {side * s, 0, kCut}}, kHalfDepth);
    card.friction = cardFriction(kAngle) + above;
    scene.bodies.push_back(card);
  }
  return scene;
}

Scene archScene(const std::string& name, int stones, Real part, Real friction) {
  constexpr Real kHalfDepth = 0.25;  // [m]
  const Real thickness = part * archAnswer(stones).thickness;
  // Of the pair of two stones; the ground rubs as they do.
  const Real own = std::sqrt(friction);
  Scene scene = standing(name, "half a circle of stones without mortar", own);
  for (int i = 0; i < stones; ++i) {
    std::vector<Vector3> outline;
    for (const int joint : {i, i + 1}) {
      const Real angle = std::numbers::pi * joint / stones;
      for (const Real radius : {1 - thickness / 2, 1 + thickness / 2}) {
        // The last joint lies on the ground as the first one does.
        const Real height = joint == stones ? 0 : radius * sine(angle);
        outline.push_back({-radius * cosine(angle), 0, height});
      }
    }
    Body stone = prism(outline, kHalfDepth);
    stone.friction = own;
    scene.bodies.push_back(stone);
  }
  scene.duration = 60;
  return scene;
}

Scene smallPyramidScene() {
  constexpr int kRows = 5;
  Scene scene = standing("S11_pyramid", "five rows of cubes, each on two below", kHalfFriction);
  for (int row = 0; row < kRows; ++row) {
    for (int i = 0; i < kRows - row; ++i) {
      const Real x = i - 0.5 * (kRows - 1 - row);
      scene.bodies.push_back(unitCube(1 / 9.81, {x, 0, row + 0.5}));
    }
  }
  scene.duration = 100, scene.lookEvery = 1;
  return scene;
}

}  // namespace carom::scenes
