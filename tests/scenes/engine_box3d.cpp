// Box3D: four sub-steps to a step.

#include <box3d/box3d.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "scenes/engines.hpp"

namespace carom::scenes {
namespace {

b3Vec3 ofVector(const Vector3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

float productOf(float a, std::uint64_t, float b, std::uint64_t) {
  return a * b;
}

class Box3d : public Engine {
 public:
  Box3d(int subSteps, int threads) : subSteps_(subSteps), threads_(threads) {}
  ~Box3d() override {
    if (b3World_IsValid(world_)) b3DestroyWorld(world_);
  }

  void build(const Scene& scene) override {
    b3WorldDef def = b3DefaultWorldDef();
    def.gravity = ofVector(scene.gravity);
    def.restitutionThreshold = scene.bounces ? 0.0f : 1.0f;
    def.maximumLinearSpeed = 1e5f;
    def.frictionCallback = productOf;
    def.restitutionCallback = productOf;
    def.enableSleep = scene.sleeps;
    def.enableContinuous = true;
    def.workerCount = static_cast<std::uint32_t>(threads_);
    world_ = b3CreateWorld(&def);
    for (const Body& body : scene.bodies) addBody(scene, body);
  }

  void step(Real dt) override {
    for (const auto& [body, force] : forces_) b3Body_ApplyForceToCenter(body, force, true);
    b3World_Step(world_, static_cast<float>(dt), subSteps_);
  }

  State state(int body) const override {
    const b3BodyId b = bodies_[static_cast<std::size_t>(body)];
    const b3Pos x = b3Body_GetPosition(b);
    const b3Quat q = b3Body_GetRotation(b);
    const b3Vec3 v = b3Body_GetLinearVelocity(b), w = b3Body_GetAngularVelocity(b);
    return {{x.x, x.y, x.z}, {q.s, q.v.x, q.v.y, q.v.z}, {v.x, v.y, v.z}, {w.x, w.y, w.z}};
  }

  std::vector<Figure> counters() const override {
    const b3Counters counters = b3World_GetCounters(world_);
    return {{"awake contacts", counters.awakeContactCount * 1.0},
            {"axes searches", counters.satCallCount * 1.0},
            {"bytes", counters.byteCount * 1.0}};
  }

 private:
  void addBody(const Scene& scene, const Body& body) {
    b3BodyDef def = b3DefaultBodyDef();
    def.type = body.moves ? b3_dynamicBody : b3_staticBody;
    const HalfSpace* half = std::get_if<HalfSpace>(&body.shape);
    // It has no half-space: a box takes its place, as large as the scene needs.
    const Real size = scene.reach;
    const Vector3 place =
        half ? Vector3(scene.middle -
                       (half->normal.dot(scene.middle) - half->offset + size) * half->normal)
             : body.start.position;
    def.position = {static_cast<decltype(def.position.x)>(place.x()),
                    static_cast<decltype(def.position.y)>(place.y()),
                    static_cast<decltype(def.position.z)>(place.z())};
    const Quaternion& q = body.start.orientation;
    def.rotation = {{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)},
                    static_cast<float>(q.w)};
    def.linearVelocity = ofVector(body.start.velocity);
    def.angularVelocity = ofVector(body.start.angularVelocity);
    def.enableSleep = scene.sleeps;
    def.allowFastRotation = true;
    const b3BodyId id = b3CreateBody(world_, &def);
    bodies_.push_back(id);

    b3ShapeDef surface = b3DefaultShapeDef();
    surface.baseMaterial.friction = static_cast<float>(body.friction);
    surface.baseMaterial.restitution = static_cast<float>(body.restitution);
    if (scene.strangers && body.moves) surface.filter.groupIndex = -1;
    if (const Ball* ball = std::get_if<Ball>(&body.shape)) {
      const b3Sphere sphere{{0, 0, 0}, static_cast<float>(ball->radius)};
      b3CreateSphereShape(id, &surface, &sphere);
    } else if (const ConvexHull* hull = std::get_if<ConvexHull>(&body.shape)) {
      std::vector<b3Vec3> points;
      for (const Vector3& v : hull->vertices) points.push_back(ofVector(v));
      const int count = static_cast<int>(points.size());
      b3HullData* data = b3CreateHull(points.data(), count, count);
      b3CreateHullShape(id, &surface, data);
      b3DestroyHull(data);
    } else {
      const Vector3 h =
          half ? Vector3(Vector3::Constant(size)) : std::get<Box>(body.shape).halfExtents;
      const b3Vec3 e = ofVector(h);
      const b3BoxHull box = b3MakeBoxHull(e.x, e.y, e.z);
      b3CreateHullShape(id, &surface, &box.base);
    }
    if (!body.moves) return;
    b3MassData mass{};
    mass.mass = static_cast<float>(body.mass);
    const b3Vec3 m = ofVector(body.moments);
    mass.inertia = {{m.x, 0, 0}, {0, m.y, 0}, {0, 0, m.z}};
    b3Body_SetMassData(id, mass);
    if (body.force != Vector3::Zero()) forces_.emplace_back(id, ofVector(body.force));
  }

  int subSteps_, threads_;
  b3WorldId world_{};
  std::vector<b3BodyId> bodies_;
  std::vector<std::pair<b3BodyId, b3Vec3>> forces_;
};

EngineKind kindOf(const std::string& name, int subSteps, bool best, int threads = 1) {
  const b3Version version = b3GetVersion();
  const std::string number = std::to_string(version.major) + "." + std::to_string(version.minor) +
                             "." + std::to_string(version.revision);
#if defined(BOX3D_DOUBLE_PRECISION)
  const std::string precision = " double positions";
#else
  const std::string precision = " float";
#endif
  return {name,
          number + precision,
          std::to_string(subSteps) +
              " sub-steps, contacts of 30 Hz and damping 10, restitution threshold 0 where bodies "
              "bounce (else 1 m/s), speed limit 1e5 m/s, continuous on; planes are large boxes",
          [](const Scene&) { return true; },
          [best](const Scene&) { return best; },
          [subSteps, threads] { return std::make_unique<Box3d>(subSteps, threads); },
          threads};
}

}  // namespace

std::vector<EngineKind> box3dEngines() {
  return {kindOf("box3d", 4, true), kindOf("box3d sub1", 1, false), kindOf("box3d sub8", 8, false),
          kindOf("box3d 2 threads", 4, false, 2)};
}

}  // namespace carom::scenes
