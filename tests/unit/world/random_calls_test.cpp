// Any calls in any order, good ones and bad ones: a world refuses what is bad and stays as it was,
// and does the rest. CAROM_RANDOM_CALLS says how many calls; a few thousand if it is not set.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"

namespace {

using namespace carom_test;

int wantedCalls() {
  constexpr int kFew = 4000;
  const char* text = std::getenv("CAROM_RANDOM_CALLS");
  const int calls = text != nullptr ? std::atoi(text) : 0;
  return calls > 0 ? calls : kFew;
}

// A number that no quantity may have.
Real badNumber(Random& random) {
  const std::array<Real, 3> bad = {std::numeric_limits<Real>::quiet_NaN(),
                                   std::numeric_limits<Real>::infinity(),
                                   -std::numeric_limits<Real>::infinity()};
  return bad[static_cast<std::size_t>(random.integer(0, 2))];
}

Vector3 badVector(Random& random) {
  Vector3 v = random.vector(3);
  const int k = random.integer(0, 2);
  v[k] = badNumber(random);
  return v;
}

Shape anyShape(Random& random) {
  const int kind = random.integer(0, 3);
  const Real a = random.between(0.1, 0.5), b = random.between(0.1, 0.5);
  if (kind == 0) return Ball{a};
  if (kind == 1) return Box{{a, b, 0.2}};
  if (kind == 2) return Capsule{a / 2, b};
  return Cylinder{a, b / 2};
}

TriangleMesh smallSheet(Random& random) {
  TriangleMesh mesh;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const Real z = random.between(-0.3, 0.3);
      mesh.vertices.push_back({2.0 * i - 3, 2.0 * j - 3, z});
    }
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int a = 4 * i + j;
      mesh.triangles.push_back({a, a + 4, a + 5});
      mesh.triangles.push_back({a, a + 5, a + 1});
    }
  }
  return mesh;
}

// A world, and what must be in it.
struct Player {
  explicit Player(std::uint64_t seed) : random(seed), world(settings()) {
    addPlane(world, 0.5, 0.2, {0, 0, 1}, {0, 0, -1});
    kept = world.save();
  }

  static WorldSettings settings() {
    WorldSettings some;
    some.maxBodies = 30;
    return some;
  }

  BodyId any() {
    return alive[static_cast<std::size_t>(random.integer(0, static_cast<int>(alive.size()) - 1))];
  }

  // An id that names nobody; a world that has gone back may know an old one again.
  BodyId stale() const {
    return world.contains(gone) ? BodyId{} : gone;
  }

  BodyDescription description() {
    BodyDescription body;
    body.position = random.vector(3) + Vector3(0, 0, 3);
    const int kind = random.integer(0, 9);
    if (kind == 0) {
      body.kind = BodyKind::immovable;
      body.position.z() = -1;
    } else {
      if (kind == 1) body.kind = BodyKind::kinematic;
      body.velocity = random.vector(4);
      body.angularVelocity = random.vector(4);
    }
    body.shapes = {made(anyShape(random), 0.4, 0.3)};
    if (kind == 0 && random.integer(0, 1) == 0) {
      body.shapes[0].ground = std::make_shared<TriangleMesh>(smallSheet(random));
    }
    return body;
  }

  // Something that must be refused. Nothing of the state may change.
  void beRefused() {
    const std::uint64_t hash = world.hash();
    const int count = world.bodyCount();
    const int what = random.integer(0, 23);
    INFO("bad call " << what);
    CHECK_THROWS_AS(callBadly(what), InvalidInput);
    CHECK(world.hash() == hash);
    CHECK(world.bodyCount() == count);
  }

  void callBadly(int what) {
    BodyDescription body = description();
    body.kind = BodyKind::dynamic;
    body.shapes[0].ground.reset();
    ShapeDescription& shape = body.shapes[0];
    switch (what) {
      case 0:
        body.position = badVector(random);
        break;
      case 1:
        body.velocity = badVector(random);
        break;
      case 2:
        body.angularVelocity = badVector(random);
        break;
      case 3:
        body.orientation = {random.between(1.1, 3), 0, 0, 0};
        break;
      case 4:
        shape.shape = Ball{-random.between(0, 1)};
        break;
      case 5:
        shape.shape = Box{{0.1, 0, 0.1}};
        break;
      case 6:
        shape.shape = HalfSpace{};
        break;
      case 7:
        shape.material.friction = -0.1;
        break;
      case 8:
        shape.material.restitution = 1.01;
        break;
      case 9:
        shape.density = badNumber(random);
        break;
      case 10:
        body.mass = MassProperties{1, -random.between(0, 2), Vector3::Zero(), Matrix3::Identity()};
        break;
      case 11: {
        // A product of inertia that no body has.
        Matrix3 inertia = Matrix3::Identity();
        inertia(0, 1) = inertia(1, 0) = 2;
        body.mass = MassProperties{1, 1, Vector3::Zero(), inertia};
        break;
      }
      case 12:
        shape.ground = std::make_shared<TriangleMesh>(smallSheet(random));
        break;
      case 13: {
        TriangleMesh mesh = smallSheet(random);
        const int broken = random.integer(0, 3);
        if (broken == 0) mesh.triangles[3][1] = 77;
        if (broken == 1) mesh.vertices[5] = badVector(random);
        if (broken == 2) std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
        if (broken == 3) mesh.triangles[2][2] = mesh.triangles[2][0];
        body.kind = BodyKind::immovable;
        body.velocity = body.angularVelocity = Vector3::Zero();
        shape.ground = std::make_shared<TriangleMesh>(mesh);
        break;
      }
      case 14:
        world.step(random.integer(0, 1) == 0 ? 0 : -kStep);
        return;
      case 15:
        world.step(badNumber(random));
        return;
      case 16:
        world.push(stale(), random.vector(1), random.vector(1));
        return;
      case 17:
        world.remove(stale());
        return;
      case 18:
        world.restore(world::Snapshot{});
        return;
      case 19:
        world.rayCast({.origin = badVector(random), .direction = {1, 0, 0}});
        return;
      case 20:
        world.overlap(Ball{0}, Pose{});
        return;
      case 21:
        world.sweep(Ball{1}, Pose{}, badVector(random), 1);
        return;
      case 22: {
        WorldSettings bad = settings();
        bad.contactMargin = -1;
        world.change(bad);
        return;
      }
      default:
        world.place(alive.empty() ? BodyId{} : any(), badVector(random), {});
        return;
    }
    world.add(body);
  }

  void add() {
    const BodyDescription body = description();
    if (world.bodyCount() < world.settings().maxBodies) {
      alive.push_back(world.add(body));
      return;
    }
    const std::uint64_t hash = world.hash();
    CHECK_THROWS_WITH(world.add(body), ContainsSubstring("number of bodies"));
    CHECK(world.hash() == hash);
  }

  void remove() {
    gone = any();
    world.remove(gone);
    alive.erase(std::find(alive.begin(), alive.end(), gone));
    CHECK_FALSE(world.contains(gone));
    CHECK_THROWS_AS(world.velocity(gone), InvalidInput);
  }

  void ask() {
    Ray ray;
    ray.origin = random.vector(3) + Vector3(0, 0, 5);
    ray.direction = random.direction();
    Pose pose;
    pose.p_WB = random.vector(3);
    const Shape shape = anyShape(random);
    const Vector3 way = random.vector(5);
    const auto hit = world.rayCast(ray);
    if (hit) CHECK(world.contains(hit->body));
    for (const BodyId body : world.overlap(shape, pose)) CHECK(world.contains(body));
    const auto swept = world.sweep(shape, pose, way, 1);
    if (swept) CHECK(world.contains(swept->body));
  }

  // Things that only a dynamic body takes.
  void push() {
    const BodyId body = any();
    const Vector3 a = random.vector(3), b = random.vector(3);
    const int what = random.integer(0, 1);
    if (std::isfinite(world.mass(body))) {
      if (what == 0) world.push(body, a, b);
      if (what == 1) world.setForce(body, a, b);
    } else {
      CHECK_THROWS_AS(world.push(body, a, b), InvalidInput);
    }
  }

  void move() {
    const BodyId body = any();
    const Vector3 where = random.vector(3) + Vector3(0, 0, 3), v = random.vector(5);
    const int what = random.integer(0, 2);
    if (what == 0) world.place(body, where, {});
    if (what == 1 && std::isfinite(world.mass(body))) world.setVelocity(body, v, where);
    if (what == 2) world.wake(body);
  }

  void call() {
    const int what = random.integer(0, 39);
    if (what < 4) return add();
    if (what < 7 && !alive.empty()) return remove();
    if (what < 12 && !alive.empty()) return push();
    if (what < 16 && !alive.empty()) return move();
    if (what < 22) return ask();
    if (what < 32) return beRefused();
    if (what == 32) {
      kept = world.save();
      keptAlive = alive;
    } else if (what == 33) {
      world.restore(kept);
      alive = keptAlive;
    } else {
      world.step(what == 34 ? random.between(1e-6, 0.05) : kStep);
      sane();
    }
  }

  void sane() {
    CHECK(world.bodyCount() == static_cast<int>(alive.size()) + 1);
    for (const BodyId body : alive) {
      CHECK(world.position(body).allFinite());
      CHECK(world.velocity(body).allFinite());
      CHECK(world.angularVelocity(body).allFinite());
    }
  }

  Random random;
  World world;
  std::vector<BodyId> alive, keptAlive;
  world::Snapshot kept;
  BodyId gone;
};

}  // namespace

TEST_CASE("any calls in any order, bad ones among them, never break a world") {
  // Worlds of some hundred calls each, so that none fills up for good.
  constexpr int kEach = 500;
  const int calls = wantedCalls();
  for (int done = 0, seed = 1; done < calls; done += kEach, ++seed) {
    INFO("seed " << seed);
    Player player(static_cast<std::uint64_t>(seed));
    for (int i = 0; i < std::min(kEach, calls - done); ++i) player.call();
    player.sane();
  }
}
