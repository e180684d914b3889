// ODE: dWorldStep for one body, dWorldQuickStep for more.

#include <ode/ode.h>

#include <array>
#include <memory>
#include <vector>

#include "scenes/engines.hpp"

namespace carom::scenes {
namespace {

class Ode : public Engine {
 public:
  Ode() {
    [[maybe_unused]] static const int once = dInitODE2(0);
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    ground_ = dSimpleSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
  }
  ~Ode() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dSpaceDestroy(ground_);
    dWorldDestroy(world_);
  }

  void build(const Scene& scene) override {
    scene_ = &scene;
    dRandSetSeed(0);  // QuickStep shuffles its rows, with a seed of the process
    one_ = movingCount(scene) == 1;
    dWorldSetGravity(world_, scene.gravity.x(), scene.gravity.y(), scene.gravity.z());
    dWorldSetQuickStepNumIterations(world_, 50);
    dWorldSetContactSurfaceLayer(world_, scene.bounces ? 0 : 0.001);
    dWorldSetAutoDisableFlag(world_, scene.sleeps ? 1 : 0);
    materials_.reserve(scene.bodies.size());
    for (const Body& body : scene.bodies) addBody(body);
  }

  void step(Real dt) override {
    for (const auto& [body, force] : forces_) {
      dBodyAddForce(body, force.x(), force.y(), force.z());
    }
    points_ = 0;
    dSpaceCollide2(reinterpret_cast<dGeomID>(space_), reinterpret_cast<dGeomID>(ground_), this,
                   &Ode::meet);
    if (!scene_->strangers) dSpaceCollide(space_, this, &Ode::meet);
    if (one_) {
      dWorldStep(world_, dt);
    } else {
      dWorldQuickStep(world_, dt);
    }
    dJointGroupEmpty(contacts_);
  }

  State state(int body) const override {
    const dBodyID b = bodies_[static_cast<std::size_t>(body)];
    if (b == nullptr) return fixed_[static_cast<std::size_t>(body)];
    const dReal *x = dBodyGetPosition(b), *q = dBodyGetQuaternion(b);
    const dReal *v = dBodyGetLinearVel(b), *w = dBodyGetAngularVel(b);
    return {{x[0], x[1], x[2]}, {q[0], q[1], q[2], q[3]}, {v[0], v[1], v[2]}, {w[0], w[1], w[2]}};
  }

  std::vector<Figure> counters() const override {
    return {{"contact points", static_cast<Real>(points_)}};
  }

 private:
  // What ODE wants to keep of a polyhedron; it does not copy.
  struct Polyhedron {
    std::vector<dReal> planes, points;
    std::vector<unsigned int> polygons;
  };

  static void meet(void* self, dGeomID a, dGeomID b) {
    static_cast<Ode*>(self)->meetHere(a, b);
  }

  void meetHere(dGeomID a, dGeomID b) {
    const dBodyID bodyA = dGeomGetBody(a), bodyB = dGeomGetBody(b);
    if (bodyA == nullptr && bodyB == nullptr) return;
    std::array<dContact, 8> contacts{};
    const int count = dCollide(a, b, 8, &contacts[0].geom, sizeof(dContact));
    const Body& one = *static_cast<const Body*>(dGeomGetData(a));
    const Body& other = *static_cast<const Body*>(dGeomGetData(b));
    for (int i = 0; i < count; ++i) {
      dSurfaceParameters& surface = contacts[static_cast<std::size_t>(i)].surface;
      surface.mode = dContactApprox1;
      surface.mu = one.friction * other.friction;
      if (scene_->bounces) {
        surface.mode |= dContactBounce;
        surface.bounce = one.restitution * other.restitution;
        surface.bounce_vel = 0;
      }
      dJointAttach(dJointCreateContact(world_, contacts_, &contacts[static_cast<std::size_t>(i)]),
                   bodyA, bodyB);
    }
    points_ += count;
  }

  dGeomID geomOf(const Shape& shape, dSpaceID space) {
    if (const Ball* ball = std::get_if<Ball>(&shape)) return dCreateSphere(space, ball->radius);
    if (const Box* box = std::get_if<Box>(&shape)) {
      const Vector3 size = 2 * box->halfExtents;
      return dCreateBox(space, size.x(), size.y(), size.z());
    }
    if (const HalfSpace* half = std::get_if<HalfSpace>(&shape)) {
      const Vector3& n = half->normal;
      return dCreatePlane(space, n.x(), n.y(), n.z(), half->offset);
    }
    const ConvexHull& hull = std::get<ConvexHull>(shape);
    polyhedra_.push_back(std::make_unique<Polyhedron>());
    Polyhedron& p = *polyhedra_.back();
    for (const Vector3& v : hull.vertices) p.points.insert(p.points.end(), {v.x(), v.y(), v.z()});
    for (const HullFace& face : hull.faces) {
      p.planes.insert(p.planes.end(),
                      {face.normal.x(), face.normal.y(), face.normal.z(), face.offset});
      p.polygons.push_back(static_cast<unsigned int>(face.count));
      for (int i = 0; i < face.count; ++i) {
        const auto edge = static_cast<std::size_t>(face.firstHalfEdge + i);
        p.polygons.push_back(static_cast<unsigned int>(hull.halfEdges[edge].origin));
      }
    }
    return dCreateConvex(space, p.planes.data(), static_cast<unsigned int>(hull.faces.size()),
                         p.points.data(), static_cast<unsigned int>(hull.vertices.size()),
                         p.polygons.data());
  }

  void addBody(const Body& body) {
    const dGeomID geom = geomOf(body.shape, body.moves ? space_ : ground_);
    materials_.push_back(body);
    dGeomSetData(geom, &materials_.back());
    const Vector3& x = body.start.position;
    const Quaternion& q = body.start.orientation;
    const dQuaternion turn{q.w, q.x, q.y, q.z};
    fixed_.push_back(body.start);
    if (!body.moves) {
      bodies_.push_back(nullptr);
      if (!std::holds_alternative<HalfSpace>(body.shape)) {
        dGeomSetPosition(geom, x.x(), x.y(), x.z());
        dGeomSetQuaternion(geom, turn);
      }
      return;
    }
    const dBodyID b = dBodyCreate(world_);
    dMass mass;
    dMassSetParameters(&mass, body.mass, 0, 0, 0, body.moments.x(), body.moments.y(),
                       body.moments.z(), 0, 0, 0);
    dBodySetMass(b, &mass);
    dBodySetPosition(b, x.x(), x.y(), x.z());
    dBodySetQuaternion(b, turn);
    const Vector3 &v = body.start.velocity, &w = body.start.angularVelocity;
    dBodySetLinearVel(b, v.x(), v.y(), v.z());
    dBodySetAngularVel(b, w.x(), w.y(), w.z());
    dGeomSetBody(geom, b);
    bodies_.push_back(b);
    if (body.force != Vector3::Zero()) forces_.emplace_back(b, body.force);
  }

  dWorldID world_;
  dSpaceID space_, ground_;
  dJointGroupID contacts_;
  const Scene* scene_ = nullptr;
  bool one_ = false;
  long points_ = 0;
  std::vector<dBodyID> bodies_;
  std::vector<State> fixed_;
  std::vector<Body> materials_;
  std::vector<std::unique_ptr<Polyhedron>> polyhedra_;
  std::vector<std::pair<dBodyID, Vector3>> forces_;
};

}  // namespace

std::vector<EngineKind> odeEngines() {
  return {{"ode", "0.16 double",
           "dWorldStep for one body, dWorldQuickStep with 50 iterations for more, ERP 0.2, surface "
           "layer 1 mm (0 where bodies bounce), up to 8 contacts a pair, friction pyramid scaled "
           "by the normal force, hash space",
           [](const Scene&) { return true; }, [](const Scene&) { return true; },
           [] { return std::make_unique<Ode>(); }}};
}

}  // namespace carom::scenes
