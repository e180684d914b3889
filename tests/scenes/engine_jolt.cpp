// Jolt: PhysicsSystem on one thread.

#include <Jolt/Jolt.h>

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/ConvexHullShape.h>
#include <Jolt/Physics/Collision/Shape/PlaneShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/PhysicsSettings.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "scenes/engines.hpp"

namespace carom::scenes {
namespace {

JPH::Vec3 ofVector(const Vector3& v) {
  return JPH::Vec3(static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()));
}

constexpr JPH::ObjectLayer kFixed = 0, kMoving = 1;

class TwoLayers final : public JPH::BroadPhaseLayerInterface {
 public:
  JPH::uint GetNumBroadPhaseLayers() const override {
    return 2;
  }
  JPH::BroadPhaseLayer GetBroadPhaseLayer(JPH::ObjectLayer layer) const override {
    return JPH::BroadPhaseLayer(static_cast<JPH::BroadPhaseLayer::Type>(layer));
  }
};

class LayerFilter final : public JPH::ObjectVsBroadPhaseLayerFilter {
 public:
  bool ShouldCollide(JPH::ObjectLayer, JPH::BroadPhaseLayer) const override {
    return true;
  }
};

class PairFilter final : public JPH::ObjectLayerPairFilter {
 public:
  bool strangers = false;
  bool ShouldCollide(JPH::ObjectLayer a, JPH::ObjectLayer b) const override {
    if (a == kFixed && b == kFixed) return false;
    return !strangers || a != b;
  }
};

struct JoltSettings {
  int collisionSteps = 1;
  bool tight = false;
};

class JoltEngine : public Engine {
 public:
  explicit JoltEngine(const JoltSettings& settings) : settings_(settings) {
    [[maybe_unused]] static const bool once = prepare();
    jobs_ = std::make_unique<JPH::JobSystemSingleThreaded>(JPH::cMaxPhysicsJobs);
  }

  void build(const Scene& scene) override {
    const auto count = static_cast<JPH::uint>(scene.bodies.size());
    memory_ = std::make_unique<JPH::TempAllocatorImpl>(64u * 1024 * 1024 + 4096u * count);
    system_ = std::make_unique<JPH::PhysicsSystem>();
    pairs_.strangers = scene.strangers;
    system_->Init(count + 16, 0, std::max(65536u, 16 * count), std::max(20480u, 8 * count), layers_,
                  filter_, pairs_);
    system_->SetGravity(ofVector(scene.gravity));
    JPH::PhysicsSettings physics = system_->GetPhysicsSettings();
    if (scene.bounces) physics.mMinVelocityForRestitution = 0;
    physics.mAllowSleeping = scene.sleeps;
    if (settings_.tight) {
      physics.mPenetrationSlop = 0.001f;
      physics.mNumVelocitySteps = 20;
      physics.mNumPositionSteps = 4;
    }
    system_->SetPhysicsSettings(physics);
    system_->SetCombineFriction(
        [](const JPH::Body& a, const JPH::SubShapeID&, const JPH::Body& b, const JPH::SubShapeID&) {
          return a.GetFriction() * b.GetFriction();
        });
    system_->SetCombineRestitution(
        [](const JPH::Body& a, const JPH::SubShapeID&, const JPH::Body& b, const JPH::SubShapeID&) {
          return a.GetRestitution() * b.GetRestitution();
        });
    for (const Body& body : scene.bodies) addBody(scene, body);
    system_->OptimizeBroadPhase();
  }

  void step(Real dt) override {
    JPH::BodyInterface& bodies = system_->GetBodyInterfaceNoLock();
    for (const auto& [body, force] : forces_) bodies.AddForce(body, force);
    system_->Update(static_cast<float>(dt), settings_.collisionSteps, memory_.get(), jobs_.get());
  }

  State state(int body) const override {
    const JPH::BodyInterface& bodies = system_->GetBodyInterfaceNoLock();
    const JPH::BodyID id = ids_[static_cast<std::size_t>(body)];
    const JPH::RVec3 x = bodies.GetCenterOfMassPosition(id);
    const JPH::Quat q = bodies.GetRotation(id);
    const JPH::Vec3 v = bodies.GetLinearVelocity(id), w = bodies.GetAngularVelocity(id);
    return {{x.GetX(), x.GetY(), x.GetZ()},
            {q.GetW(), q.GetX(), q.GetY(), q.GetZ()},
            {v.GetX(), v.GetY(), v.GetZ()},
            {w.GetX(), w.GetY(), w.GetZ()}};
  }

 private:
  static bool prepare() {
    JPH::RegisterDefaultAllocator();
    JPH::Factory::sInstance = new JPH::Factory();
    JPH::RegisterTypes();
    return true;
  }

  static JPH::RefConst<JPH::Shape> shapeOf(const Scene& scene, const Shape& shape) {
    if (const Ball* ball = std::get_if<Ball>(&shape)) {
      return new JPH::SphereShape(static_cast<float>(ball->radius));
    }
    if (const Box* box = std::get_if<Box>(&shape)) {
      // Its default radius of 5 cm where it fits.
      const auto least = static_cast<float>(box->halfExtents.minCoeff());
      return new JPH::BoxShape(ofVector(box->halfExtents),
                               std::min(JPH::cDefaultConvexRadius, least / 2));
    }
    if (const HalfSpace* half = std::get_if<HalfSpace>(&shape)) {
      const auto reach = static_cast<float>(scene.middle.norm() + 2 * scene.reach);
      return new JPH::PlaneShape(
          JPH::Plane(ofVector(half->normal), static_cast<float>(-half->offset)), nullptr, reach);
    }
    JPH::Array<JPH::Vec3> points;
    for (const Vector3& v : std::get<ConvexHull>(shape).vertices) points.push_back(ofVector(v));
    return JPH::ConvexHullShapeSettings(points).Create().Get();
  }

  void addBody(const Scene& scene, const Body& body) {
    const Vector3& x = body.start.position;
    const Quaternion& q = body.start.orientation;
    JPH::BodyCreationSettings settings(
        shapeOf(scene, body.shape),
        JPH::RVec3(JPH::Real(x.x()), JPH::Real(x.y()), JPH::Real(x.z())),
        JPH::Quat(static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
                  static_cast<float>(q.w)),
        body.moves ? JPH::EMotionType::Dynamic : JPH::EMotionType::Static,
        body.moves ? kMoving : kFixed);
    settings.mFriction = static_cast<float>(body.friction);
    settings.mRestitution = static_cast<float>(body.restitution);
    settings.mLinearDamping = settings.mAngularDamping = 0;
    settings.mMaxLinearVelocity = 1e5f;
    settings.mMaxAngularVelocity = 1e4f;
    settings.mAllowSleeping = scene.sleeps;
    settings.mApplyGyroscopicForce = true;
    if (scene.fast && body.moves) settings.mMotionQuality = JPH::EMotionQuality::LinearCast;
    if (body.moves) {
      settings.mLinearVelocity = ofVector(body.start.velocity);
      settings.mAngularVelocity = ofVector(body.start.angularVelocity);
      settings.mOverrideMassProperties = JPH::EOverrideMassProperties::MassAndInertiaProvided;
      settings.mMassPropertiesOverride.mMass = static_cast<float>(body.mass);
      settings.mMassPropertiesOverride.mInertia = JPH::Mat44::sScale(ofVector(body.moments));
    }
    JPH::BodyInterface& bodies = system_->GetBodyInterfaceNoLock();
    ids_.push_back(bodies.CreateAndAddBody(
        settings, body.moves ? JPH::EActivation::Activate : JPH::EActivation::DontActivate));
    if (body.force != Vector3::Zero()) forces_.emplace_back(ids_.back(), ofVector(body.force));
  }

  JoltSettings settings_;
  TwoLayers layers_;
  LayerFilter filter_;
  PairFilter pairs_;
  std::unique_ptr<JPH::JobSystem> jobs_;
  std::unique_ptr<JPH::TempAllocatorImpl> memory_;
  std::unique_ptr<JPH::PhysicsSystem> system_;
  std::vector<JPH::BodyID> ids_;
  std::vector<std::pair<JPH::BodyID, JPH::Vec3>> forces_;
};

EngineKind kindOf(const std::string& name, const std::string& words, const JoltSettings& settings,
                  std::function<bool(const Scene&)> best) {
  const std::string version = std::to_string(JPH_VERSION_MAJOR) + "." +
                              std::to_string(JPH_VERSION_MINOR) + "." +
                              std::to_string(JPH_VERSION_PATCH);
#if defined(JPH_DOUBLE_PRECISION)
  const std::string precision = " double positions";
#else
  const std::string precision = " float";
#endif
  return {name,
          version + precision,
          words +
              ", Baumgarte 0.2, speculative 2 cm, convex radius 5 cm, restitution threshold 0 "
              "where bodies bounce (else 1 m/s), no damping, gyroscopic force on, fast bodies "
              "by LinearCast",
          [](const Scene&) { return true; },
          std::move(best),
          [settings] { return std::make_unique<JoltEngine>(settings); }};
}

}  // namespace

std::vector<EngineKind> joltEngines() {
  return {kindOf("jolt", "10 velocity and 2 position iterations, slop 2 cm", {},
                 [](const Scene&) { return true; }),
          kindOf("jolt cs4", "the same, 4 collision steps to a step", {.collisionSteps = 4},
                 [](const Scene& s) { return s.tall; }),
          kindOf("jolt tight", "20 velocity and 4 position iterations, slop 1 mm", {.tight = true},
                 [](const Scene&) { return false; })};
}

}  // namespace carom::scenes
