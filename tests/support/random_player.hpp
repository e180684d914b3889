#pragma once
// Any calls in any order, good ones and bad ones: a world refuses what is bad and stays as it was,
// and does the rest. What does not hold is thrown.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "support/random_shapes.hpp"
#include "unit/world/scene_parts.hpp"

namespace carom_test {

// A number that no quantity may have.
inline Real badNumber(Random& random) {
  const std::array<Real, 3> bad = {std::numeric_limits<Real>::quiet_NaN(),
                                   std::numeric_limits<Real>::infinity(),
                                   -std::numeric_limits<Real>::infinity()};
  return bad[static_cast<std::size_t>(random.integer(0, 2))];
}

inline Vector3 badVector(Random& random) {
  Vector3 v = random.vector(3);
  const int k = random.integer(0, 2);
  v[k] = badNumber(random);
  return v;
}

// What must hold, and otherwise ends the game.
inline void must(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

template <class Call>
void mustRefuse(const Call& call, const std::string& what) {
  try {
    call();
  } catch (const InvalidInput&) {
    return;
  }
  throw std::runtime_error(what + " was not refused");
}

// A world, and what must be in it.
struct Player {
  explicit Player(std::uint64_t seed) : random(seed), world(settings()) {
    addPlane(world, 0.5, 0.2, {0, 0, 1}, {0, 0, -1});
    kept = world.save();
  }

  static WorldSettings settings() {
    WorldSettings some;
    some.maxBodies = 60;
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
    body.shapes = {made(randomShape(random, 0.5), 0.4, 0.3)};
    if (kind == 0 && random.integer(0, 1) == 0) {
      body.shapes[0].ground = std::make_shared<TriangleMesh>(randomSheet(random, 3, 0.3));
    }
    return body;
  }

  // Something that must be refused. Nothing of the state may change.
  void beRefused() {
    const std::uint64_t hash = world.hash();
    const int count = world.bodyCount();
    const int what = random.integer(0, 25);
    mustRefuse([&] { callBadly(what); }, "bad call " + std::to_string(what));
    must(world.hash() == hash, "a refused call changed the world");
    must(world.bodyCount() == count, "a refused call changed the number of bodies");
    ++refused;
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
        body.orientation = {random.integer(0, 1) == 0 ? 0 : random.between(1.1, 3), 0, 0, 0};
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
        shape.ground = std::make_shared<TriangleMesh>(randomSheet(random, 3, 0.3));
        break;
      case 13: {
        TriangleMesh mesh = randomSheet(random, 3, 0.3);
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
      case 23:
        world.place(alive.empty() ? BodyId{} : any(), badVector(random), {});
        return;
      case 24:
        world.place(alive.empty() ? BodyId{} : any(), random.vector(1), {0, 0, 0, 0});
        return;
      default:
        world.advance(random.between(1e-3, 0.1), badNumber(random));
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
    mustRefuse([&] { world.add(body); }, "a body too many");
    must(world.hash() == hash, "a refused call changed the world");
  }

  void remove() {
    gone = any();
    world.remove(gone);
    alive.erase(std::find(alive.begin(), alive.end(), gone));
    must(!world.contains(gone), "one who is gone is known");
    mustRefuse([&] { world.velocity(gone); }, "the velocity of one who is gone");
  }

  void ask() {
    Ray ray;
    ray.origin = random.vector(3) + Vector3(0, 0, 5);
    ray.direction = random.direction();
    Pose pose;
    pose.p_WB = random.vector(3);
    const Shape shape = randomShape(random, 0.5);
    const Vector3 way = random.vector(5);
    const auto hit = world.rayCast(ray);
    if (hit) must(world.contains(hit->body), "a ray met nobody");
    for (const BodyId body : world.overlap(shape, pose))
      must(world.contains(body), "nobody overlaps");
    const auto swept = world.sweep(shape, pose, way, 1);
    if (swept) must(world.contains(swept->body), "a sweep met nobody");
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
      mustRefuse([&] { world.push(body, a, b); }, "a push of what no force moves");
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
      ++steps;
      const Real time = random.between(1e-6, 0.05);
      if (what == 35) {
        world.advance(time, 1e-3);
      } else {
        world.step(what == 34 ? time : kStep);
      }
      sane();
    }
  }

  void sane() {
    must(world.bodyCount() == static_cast<int>(alive.size()) + 1, "bodies were lost");
    for (const BodyId body : alive) {
      must(world.position(body).allFinite(), "a position is no number");
      must(world.velocity(body).allFinite(), "a velocity is no number");
      must(world.angularVelocity(body).allFinite(), "an angular velocity is no number");
    }
  }

  Random random;
  World world;
  std::vector<BodyId> alive, keptAlive;
  world::Snapshot kept;
  BodyId gone;
  long steps = 0, refused = 0;
};

}  // namespace carom_test
