// Calls that must be refused.

#include <functional>
#include <limits>
#include <memory>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "scenes/stress.hpp"
#include "support/random_shapes.hpp"
#include "unit/world/scene_parts.hpp"

namespace carom::stress {
namespace {

using namespace carom_test;
using carom_test::addPlane;

constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();
constexpr Real kInfinite = std::numeric_limits<Real>::infinity();

struct Refusal {
  std::string what;
  std::string name;  // that the message must have: what is wrong
  std::function<void(World&)> call;
};

BodyDescription goodBody() {
  BodyDescription body;
  body.position = {0, 0, 5};
  body.shapes = {made(Ball{0.5}, 0.5, 0)};
  return body;
}

Refusal refused(const std::string& what, const std::string& name,
                const std::function<void(BodyDescription&)>& change) {
  return {what, name, [change](World& world) {
            BodyDescription body = goodBody();
            change(body);
            world.add(body);
          }};
}

void addNumbers(std::vector<Refusal>& all) {
  for (const Real bad : {kNan, kInfinite, -kInfinite}) {
    for (int k = 0; k < 3; ++k) {
      const auto set = [bad, k](Vector3& v) { v[k] = bad; };
      all.push_back(refused("position not finite", "position", [=](auto& b) { set(b.position); }));
      all.push_back(refused("velocity not finite", "velocity", [=](auto& b) { set(b.velocity); }));
      all.push_back(refused("angular velocity not finite", "angularVelocity",
                            [=](auto& b) { set(b.angularVelocity); }));
      all.push_back(refused("half extents not finite", "half extent", [=](auto& b) {
        Vector3 half = Vector3::Ones();
        set(half);
        b.shapes[0].shape = Box{half};
      }));
      all.push_back(refused("centre of mass not finite", "centre of mass", [=](auto& b) {
        Vector3 centre = Vector3::Zero();
        set(centre);
        b.mass = MassProperties{1, 1, centre, Matrix3::Identity()};
      }));
      all.push_back(refused("inertia not finite", "inertia", [=](auto& b) {
        Matrix3 inertia = Matrix3::Identity();
        inertia(k, k) = bad;
        b.mass = MassProperties{1, 1, Vector3::Zero(), inertia};
      }));
      all.push_back(refused("ground not finite", "", [=](auto& b) {
        Random random(1);
        TriangleMesh mesh = randomSheet(random, 2, 0.2);
        set(mesh.vertices[5]);
        b.kind = BodyKind::immovable;
        b.shapes[0].ground = std::make_shared<TriangleMesh>(mesh);
      }));
      all.push_back({"gravity not finite", "gravity", [=](World& world) {
                       WorldSettings settings = world.settings();
                       set(settings.gravity);
                       world.change(settings);
                     }});
      all.push_back({"place not finite", "position", [=](World& world) {
                       Vector3 where = Vector3::Zero();
                       set(where);
                       world.place(world.bodies()[1], where, {});
                     }});
      all.push_back({"impulse not finite", "impulse", [=](World& world) {
                       Vector3 impulse = Vector3::Zero();
                       set(impulse);
                       world.push(world.bodies()[1], impulse, Vector3::Zero());
                     }});
      all.push_back({"force not finite", "force", [=](World& world) {
                       Vector3 force = Vector3::Zero();
                       set(force);
                       world.setForce(world.bodies()[1], force);
                     }});
      all.push_back({"velocity set not finite", "velocity", [=](World& world) {
                       Vector3 velocity = Vector3::Zero();
                       set(velocity);
                       world.setVelocity(world.bodies()[1], velocity, Vector3::Zero());
                     }});
      all.push_back({"ray from nowhere", "origin", [=](World& world) {
                       Ray ray;
                       ray.direction = Vector3::UnitX();
                       set(ray.origin);
                       world.rayCast(ray);
                     }});
    }
    all.push_back(refused("orientation not finite", "orientation", [=](auto& b) {
      b.orientation = {bad, 0, 0, 0};
    }));
    all.push_back(refused("friction not finite", "friction",
                          [=](auto& b) { b.shapes[0].material.friction = bad; }));
    all.push_back(refused("restitution not finite", "restitution",
                          [=](auto& b) { b.shapes[0].material.restitution = bad; }));
    all.push_back(
        refused("density not finite", "density", [=](auto& b) { b.shapes[0].density = bad; }));
    all.push_back(
        refused("radius not finite", "radius", [=](auto& b) { b.shapes[0].shape = Ball{bad}; }));
    all.push_back(refused("mass not finite", "mass", [=](auto& b) {
      b.mass = MassProperties{1, bad, Vector3::Zero(), Matrix3::Identity()};
    }));
    all.push_back({"step not finite", "dt", [=](World& world) { world.step(bad); }});
    all.push_back(
        {"duration not finite", "duration", [=](World& world) { world.advance(bad, 1e-3); }});
    all.push_back(
        {"tolerance not finite", "tolerance", [=](World& world) { world.advance(0.1, bad); }});
  }
}

void addRanges(std::vector<Refusal>& all) {
  const auto mass = [](Real value, const Matrix3& inertia) {
    return MassProperties{1, value, Vector3::Zero(), inertia};
  };
  for (const Real bad : {Real(0), Real(-1), -1e-300}) {
    all.push_back({"step zero or negative", "dt", [=](World& world) { world.step(bad); }});
    all.push_back({"duration", "duration", [=](World& world) { world.advance(bad, 1e-3); }});
    all.push_back({"tolerance", "tolerance", [=](World& world) { world.advance(0.1, bad); }});
    all.push_back(refused("radius", "radius", [=](auto& b) { b.shapes[0].shape = Ball{bad}; }));
    all.push_back(refused("capsule", "", [=](auto& b) { b.shapes[0].shape = Capsule{0.1, bad}; }));
    all.push_back(refused("cylinder", "", [=](auto& b) {
      b.shapes[0].shape = Cylinder{bad, 0.1};
    }));
    all.push_back(refused("box", "half extent", [=](auto& b) {
      b.shapes[0].shape = Box{{1, bad, 1}};
    }));
    all.push_back(refused("density", "density", [=](auto& b) { b.shapes[0].density = bad; }));
    all.push_back(
        refused("mass", "mass", [=](auto& b) { b.mass = mass(bad, Matrix3::Identity()); }));
    all.push_back(refused("inertia", "inertia",
                          [=](auto& b) { b.mass = mass(1, bad * Matrix3::Identity()); }));
    all.push_back(refused("one moment", "inertia",
                          [=](auto& b) { b.mass = mass(1, Vector3(1, bad, 1).asDiagonal()); }));
    all.push_back({"contact margin", "contactMargin", [=](World& world) {
                     WorldSettings settings = world.settings();
                     settings.contactMargin = bad;
                     world.change(settings);
                   }});
    all.push_back({"sleep time", "sleepTime", [=](World& world) {
                     WorldSettings settings = world.settings();
                     settings.sleepTime = bad;
                     world.change(settings);
                   }});
  }
  all.push_back(refused("inertia not symmetric", "inertia", [=](auto& b) {
    Matrix3 inertia = Matrix3::Identity();
    inertia(0, 1) = 0.5;
    b.mass = mass(1, inertia);
  }));
  all.push_back(refused("inertia not definite", "inertia", [=](auto& b) {
    Matrix3 inertia = Matrix3::Identity();
    inertia(0, 1) = inertia(1, 0) = 2;
    b.mass = mass(1, inertia);
  }));
  all.push_back(refused("quaternion zero", "orientation", [](auto& b) {
    b.orientation = {0, 0, 0, 0};
  }));
  all.push_back(refused("quaternion of norm two", "orientation", [](auto& b) {
    b.orientation = {2, 0, 0, 0};
  }));
  all.push_back({"quaternion zero to place", "orientation", [](World& world) {
                   world.place(world.bodies()[1], Vector3::Zero(), {0, 0, 0, 0});
                 }});
  all.push_back(refused("negative friction", "friction",
                        [](auto& b) { b.shapes[0].material.friction = -0.1; }));
  for (const Real bad : {-0.1, 1.1}) {
    all.push_back(refused("restitution", "restitution",
                          [=](auto& b) { b.shapes[0].material.restitution = bad; }));
  }
  all.push_back(refused("no shape and no mass", "", [](auto& b) { b.shapes.clear(); }));
  all.push_back(refused("a half-space that falls", "half-space",
                        [](auto& b) { b.shapes[0].shape = HalfSpace{}; }));
  all.push_back(
      refused("a hull of no corners", "", [](auto& b) { b.shapes[0].shape = ConvexHull{}; }));
  all.push_back(
      refused("a compound of no parts", "", [](auto& b) { b.shapes[0].shape = Compound{}; }));
  all.push_back(refused("an immovable body that moves", "velocity", [](auto& b) {
    b.kind = BodyKind::immovable;
    b.velocity = {1, 0, 0};
  }));
  all.push_back(refused("ground that falls", "ground", [](auto& b) {
    Random random(1);
    b.shapes[0].ground = std::make_shared<TriangleMesh>(randomSheet(random, 2, 0.2));
  }));
  all.push_back(refused("ground with a corner that is none", "", [](auto& b) {
    Random random(1);
    TriangleMesh mesh = randomSheet(random, 2, 0.2);
    mesh.triangles[3][1] = 77;
    b.kind = BodyKind::immovable;
    b.shapes[0].ground = std::make_shared<TriangleMesh>(mesh);
  }));
}

void addIds(std::vector<Refusal>& all) {
  const auto gone = [](const World& world) {
    // Its place has been taken by another since.
    BodyId id = world.bodies().back();
    --id.generation;
    return id;
  };
  all.push_back({"null id", "body id", [](World& world) { world.remove(BodyId{}); }});
  all.push_back({"stale id removed", "body id", [=](World& world) { world.remove(gone(world)); }});
  all.push_back({"stale id woken", "body id", [=](World& world) { world.wake(gone(world)); }});
  all.push_back({"stale id placed", "body id",
                 [=](World& world) { world.place(gone(world), Vector3::Zero(), {}); }});
  all.push_back({"stale id asked", "body id", [=](World& world) { world.velocity(gone(world)); }});
  all.push_back({"a wall pushed", "dynamic", [](World& world) {
                   world.push(world.bodies()[0], Vector3::UnitX(), Vector3::Zero());
                 }});
  all.push_back({"a wall set in motion", "immovable", [](World& world) {
                   world.setVelocity(world.bodies()[0], Vector3::UnitX(), Vector3::Zero());
                 }});
  all.push_back({"an empty snapshot", "snapshot", [](World& world) { world.restore({}); }});
  all.push_back({"a body too many", "number of bodies", [](World& world) {
                   const WorldSettings before = world.settings();
                   WorldSettings settings = before;
                   settings.maxBodies = world.bodyCount();
                   world.change(settings);
                   try {
                     world.add(goodBody());
                   } catch (const InvalidInput&) {
                     world.change(before);
                     throw;
                   }
                 }});
}

void fill(World& world) {
  addPlane(world, 0.5, 0.2);
  for (int i = 0; i < 4; ++i) {
    addBox(world, Vector3::Constant(0.5),
           {.position = {0.3 * i, 0, 0.6 + 1.1 * i}, .friction = 0.5});
    addBall(world, 0.3, {.position = {3.0, 0.2 * i, 1.0 + i}, .restitution = 0.5});
  }
  // One goes and another takes its place.
  world.remove(world.bodies().back());
  world.add(goodBody());
  run(world, 20);
}

}  // namespace

Outcome refuseAll() {
  std::vector<Refusal> all;
  addIds(all);
  addNumbers(all);
  addRanges(all);
  Outcome outcome;
  outcome.tally.scenes = 1;
  World world, twin;
  fill(world);
  fill(twin);
  for (const Refusal& refusal : all) {
    const auto fail = [&](const std::string& what) {
      if (outcome.failure.empty()) outcome.failure = refusal.what + ": " + what;
    };
    const std::uint64_t hash = world.hash();
    const Real energy = world.energy(), time = world.time();
    try {
      refusal.call(world);
      fail("was not refused");
    } catch (const InvalidInput& refusing) {
      const std::string text = refusing.what();
      if (text.find(refusal.name) == std::string::npos) fail("says \"" + text + "\"");
      ++outcome.tally.refused;
    } catch (const std::exception& other) {
      fail(std::string("ended with another error: ") + other.what());
    }
    if (world.hash() != hash || world.energy() != energy || world.time() != time ||
        world.bodyCount() != twin.bodyCount()) {
      fail("changed the world");
    }
    // What does not show may have changed all the same: then it goes on otherwise.
    world.step(kStep);
    twin.step(kStep);
    ++outcome.tally.steps;
    if (world.hash() != twin.hash()) fail("made the world go on otherwise");
    if (!outcome.failure.empty()) return outcome;
  }
  return outcome;
}

}  // namespace carom::stress
