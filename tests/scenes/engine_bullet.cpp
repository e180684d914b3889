// Bullet: btDiscreteDynamicsWorld with sequential impulses.

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "scenes/engines.hpp"

extern btScalar gContactBreakingThreshold;  // Bullet has it as a global

namespace carom::scenes {
namespace {

btVector3 ofVector(const Vector3& v) {
  return {v.x(), v.y(), v.z()};
}

Vector3 toVector(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

struct BulletSettings {
  int iterations = 10;
  bool forBounces = false;
};

class Bullet : public Engine {
 public:
  explicit Bullet(const BulletSettings& settings)
      : settings_(settings),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {}
  ~Bullet() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  void build(const Scene& scene) override {
    gContactBreakingThreshold = settings_.forBounces ? 1e-4 : 0.02;
    world_.setGravity(ofVector(scene.gravity));
    btContactSolverInfo& solver = world_.getSolverInfo();
    solver.m_numIterations = settings_.iterations;
    if (scene.bounces) solver.m_restitutionVelocityThreshold = 0;
    if (settings_.forBounces) solver.m_splitImpulsePenetrationThreshold = 0;
    for (const Body& body : scene.bodies) addBody(scene, body);
  }

  void step(Real dt) override {
    for (const auto& [body, force] : forces_) body->applyCentralForce(force);
    world_.stepSimulation(dt, 0);
  }

  State state(int body) const override {
    const btRigidBody& b = *bodies_[static_cast<std::size_t>(body)];
    const btQuaternion q = b.getWorldTransform().getRotation();
    return {toVector(b.getWorldTransform().getOrigin()),
            {q.w(), q.x(), q.y(), q.z()},
            toVector(b.getLinearVelocity()),
            toVector(b.getAngularVelocity())};
  }

  std::vector<Figure> counters() const override {
    Real points = 0;
    const int manifolds = dispatcher_.getNumManifolds();
    for (int i = 0; i < manifolds; ++i) {
      points += dispatcher_.getInternalManifoldPointer()[i]->getNumContacts();
    }
    return {{"manifolds", manifolds * 1.0}, {"contact points", points}};
  }

 private:
  std::unique_ptr<btCollisionShape> shapeOf(const Shape& shape) {
    if (const Ball* ball = std::get_if<Ball>(&shape)) {
      return std::make_unique<btSphereShape>(ball->radius);
    }
    if (const Box* box = std::get_if<Box>(&shape)) {
      return std::make_unique<btBoxShape>(ofVector(box->halfExtents));
    }
    if (const HalfSpace* half = std::get_if<HalfSpace>(&shape)) {
      return std::make_unique<btStaticPlaneShape>(ofVector(half->normal), half->offset);
    }
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vector3& p : std::get<ConvexHull>(shape).vertices)
      hull->addPoint(ofVector(p), false);
    hull->recalcLocalAabb();
    hull->setMargin(0.01);
    return hull;
  }

  void addBody(const Scene& scene, const Body& body) {
    shapes_.push_back(shapeOf(body.shape));
    btRigidBody::btRigidBodyConstructionInfo info(body.moves ? body.mass : 0, nullptr,
                                                  shapes_.back().get(), ofVector(body.moments));
    if (!body.moves) info.m_localInertia = btVector3(0, 0, 0);
    info.m_friction = body.friction;
    info.m_restitution = body.restitution;
    const Quaternion& q = body.start.orientation;
    info.m_startWorldTransform =
        btTransform(btQuaternion(q.x, q.y, q.z, q.w), ofVector(body.start.position));
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& b = *bodies_.back();
    b.setDamping(0, 0);
    if (body.moves) {
      b.setLinearVelocity(ofVector(body.start.velocity));
      b.setAngularVelocity(ofVector(body.start.angularVelocity));
      if (!scene.sleeps) b.setActivationState(DISABLE_DEACTIVATION);
      if (body.force != Vector3::Zero()) forces_.emplace_back(&b, ofVector(body.force));
      if (scene.fast) {
        const Real radius = std::get<Ball>(body.shape).radius;
        b.setCcdMotionThreshold(radius / 2);
        b.setCcdSweptSphereRadius(0.8 * radius);
      }
    }
    const int moving = 1, fixed = 2;
    const int meets = body.moves ? (scene.strangers ? fixed : moving | fixed) : moving;
    world_.addRigidBody(&b, body.moves ? moving : fixed, meets);
  }

  BulletSettings settings_;
  btDefaultCollisionConfiguration configuration_;
  mutable btCollisionDispatcher dispatcher_;  // it has no way to look without touching
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::pair<btRigidBody*, btVector3>> forces_;
};

EngineKind kindOf(const std::string& name, const std::string& words, const BulletSettings& settings,
                  std::function<bool(const Scene&)> best) {
  const std::string version = std::to_string(BT_BULLET_VERSION / 100) + "." +
                              std::to_string(BT_BULLET_VERSION % 100) + " double";
  return {name,
          version,
          words,
          [](const Scene&) { return true; },
          std::move(best),
          [settings] { return std::make_unique<Bullet>(settings); }};
}

}  // namespace

std::vector<EngineKind> bulletEngines() {
  const std::string common =
      "Dbvt, warm starting, static planes, no damping; continuous: motion threshold r/2, swept "
      "radius 0.8 r; hull margin 1 cm; ";
  return {kindOf("bullet", common + "10 iterations", {}, [](const Scene& s) { return !s.bounces; }),
          kindOf("bullet rest",
                 common + "10 iterations, contact breaking threshold 0.1 mm and split impulses "
                          "always: without these bounces are lost or gain energy",
                 {.forBounces = true}, [](const Scene& s) { return s.bounces; }),
          kindOf("bullet it50", common + "50 iterations", {.iterations = 50},
                 [](const Scene& s) { return s.tall; })};
}

}  // namespace carom::scenes
