// Ground made of triangles: the same motion as on one floor, edges, speed, and what is refused.

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/world/ground.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"

namespace {

using namespace carom_test;
using carom_test::add;

// A sheet over the square [-half, half]^2 whose inner vertices are shaken, with the heights of a
// function.
template <class Height>
TriangleMesh shakenSheet(Real half, int cells, std::uint64_t seed, const Height& height) {
  Random random(seed);
  TriangleMesh mesh;
  const Real cell = 2 * half / cells;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const bool inside = i > 0 && j > 0 && i < cells && j < cells;
      const Real dx = random.between(-0.3, 0.3), dy = random.between(-0.3, 0.3);
      const Real x = -half + cell * (i + (inside ? dx : 0));
      const Real y = -half + cell * (j + (inside ? dy : 0));
      mesh.vertices.push_back({x, y, height(x, y)});
    }
  }
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const int a = i * (cells + 1) + j, b = a + cells + 1;
      if (random.integer(0, 1) == 0) {
        mesh.triangles.push_back({a, b, b + 1});
        mesh.triangles.push_back({a, b + 1, a + 1});
      } else {
        mesh.triangles.push_back({a, b, a + 1});
        mesh.triangles.push_back({b, b + 1, a + 1});
      }
    }
  }
  return mesh;
}

TriangleMesh flatSheet(Real half, int cells, std::uint64_t seed = 1) {
  return shakenSheet(half, cells, seed, [](Real, Real) { return Real(0); });
}

BodyId addGround(World& world, const TriangleMesh& mesh, Real friction, Real restitution) {
  BodyDescription body;
  body.kind = BodyKind::immovable;
  body.shapes = {made(Ball{}, friction, restitution)};
  body.shapes[0].ground = std::make_shared<TriangleMesh>(mesh);
  return world.add(body);
}

struct Farthest {
  Real place = 0, turn = 0, speed = 0;
};

// How far a thing on a sheet of triangles is from where it is on one floor, at worst.
template <class Put>
Farthest differenceOf(const TriangleMesh& mesh, Real friction, Real restitution, int steps,
                      const Put& put) {
  World floor(awake()), sheet(awake());
  addPlane(floor, friction, restitution);
  addGround(sheet, mesh, friction, restitution);
  const BodyId one = put(floor), other = put(sheet);
  Farthest far;
  for (int k = 0; k < steps; ++k) {
    floor.step(kStep);
    sheet.step(kStep);
    const Quaternion p = floor.orientation(one), q = sheet.orientation(other);
    far.place = std::max(far.place, (floor.position(one) - sheet.position(other)).norm());
    far.speed = std::max(far.speed, (floor.velocity(one) - sheet.velocity(other)).norm());
    far.turn = std::max({far.turn, std::abs(p.w - q.w), std::abs(p.x - q.x), std::abs(p.y - q.y),
                         std::abs(p.z - q.z)});
  }
  return far;
}

}  // namespace

TEST_CASE("a box slides over a floor of triangles as over one floor") {
  for (const int cells : {4, 12, 40}) {
    const auto put = [](World& world) {
      return addBox(world, {0.5, 0.4, 0.3},
                    {.position = {-5, 0.1, 0.3}, .velocity = {7, 1, 0}, .friction = 0.5});
    };
    const Farthest far = differenceOf(flatSheet(10, cells), 0.5, 0, 180, put);
    INFO(cells << " cells");
    CHECK(far.place < 1e-11);
    CHECK(far.turn < 1e-12);
    CHECK(far.speed < 1e-11);
  }
}

TEST_CASE("a ball rolls, and slides before, over a floor of triangles as over one floor") {
  for (const int cells : {4, 12, 40}) {
    const auto put = [](World& world) {
      return addBall(world, 0.3,
                     {.position = {-8, 0.2, 0.3}, .velocity = {5, 0.3, 0}, .friction = 0.3});
    };
    const Farthest far = differenceOf(flatSheet(10, cells), 0.3, 0, 180, put);
    INFO(cells << " cells");
    CHECK(far.place < 1e-12);
    CHECK(far.turn < 1e-12);
    CHECK(far.speed < 1e-12);
  }
}

TEST_CASE("a ball bounces on a floor of triangles as on one floor") {
  const auto put = [](World& world) {
    return addBall(world, 0.3,
                   {.position = {-8, 0.2, 2}, .velocity = {5, 0.3, 0}, .restitution = 0.7});
  };
  const Farthest far = differenceOf(flatSheet(10, 30), 0, 0.7, 180, put);
  CHECK(far.place < 1e-10);
  CHECK(far.speed < 1e-9);
}

TEST_CASE("a capsule and a hull slide over a floor of triangles as over one floor") {
  const auto capsule = [](World& world) {
    const Real half = std::sqrt(0.5);
    Thing thing{.position = {-5, 0, 0.2}, .velocity = {5, 0, 0}, .friction = 0.4};
    thing.orientation = {half, 0, half, 0};  // along x
    return add(world, Capsule{0.2, 0.5}, 0.2, thing);
  };
  const Farthest far = differenceOf(flatSheet(10, 20), 0.4, 0, 120, capsule);
  CHECK(far.place < 1e-10);
  CHECK(far.turn < 1e-10);
  const auto hull = [](World& world) {
    std::vector<Vector3> corners;
    for (int k = 0; k < 6; ++k) {
      const Real angle = k * std::numbers::pi / 3;
      const Real x = 0.5 * std::cos(angle), y = 0.5 * std::sin(angle);
      corners.push_back({x, y, -0.2});
      corners.push_back({x, y, 0.2});
    }
    return add(world, hullOfPoints(corners), 0.3,
               {.position = {-5, 0, 0.2}, .velocity = {6, 0.5, 0}, .friction = 0.4});
  };
  // Six corners are more than a manifold of one floor has: here the exact motion is the judge.
  World world(awake());
  addGround(world, flatSheet(10, 20), 0.4, 0);
  const BodyId body = hull(world);
  const Vector3 start(-5, 0, 0.2), velocity(6, 0.5, 0);
  for (int k = 1; k <= 60; ++k) {
    world.step(kStep);
    const Real time = k * kStep, way = velocity.norm() * time - 0.2 * kGravity * time * time;
    CHECK((world.position(body) - start - way * velocity.normalized()).norm() < 1e-11);
    CHECK(std::abs(world.orientation(body).z) < 1e-12);
  }
}

TEST_CASE("a box that lies on many triangles has four points, and none asks more of it") {
  World world(awake());
  addGround(world, flatSheet(10, 100), 0.5, 0);
  addBox(world, {1, 1, 0.2}, {.position = {0.03, 0.05, 0.2}, .friction = 0.5});
  run(world, 1);
  CHECK(world.counters().contactPoints == 4);
  CHECK(world.counters().normalRows == 4);
}

TEST_CASE("a ball leaves a table at its rim, not a step later") {
  for (const Real speed : {2.0, 5.3, 40.0}) {
    World world(awake());
    addGround(world, flatSheet(2, 6), 0, 0);
    const Real radius = 0.1, start = -1;
    const BodyId ball =
        addBall(world, radius, {.position = {start, 0.1, radius}, .velocity = {speed, 0, 0}});
    const Real leaves = (2 - start) / speed;
    const int steps = static_cast<int>(leaves / kStep) + 5;
    run(world, steps);
    const Real flown = steps * kStep - leaves;
    INFO("speed " << speed);
    CHECK_THAT(world.position(ball).x(), WithinAbs(start + speed * steps * kStep, 1e-10));
    CHECK_THAT(world.position(ball).z(), WithinAbs(radius - kGravity * flown * flown / 2, 1e-10));
  }
}

TEST_CASE("a ball over a roof's ridge flies, and lands on the other side") {
  // Up one side, 30 degrees, and down the other.
  TriangleMesh roof;
  const Real rise = std::tan(std::numbers::pi / 6);
  for (const Real x : {-4.0, 0.0, 4.0}) {
    for (const Real y : {-2.0, 2.0}) roof.vertices.push_back({x, y, -rise * std::abs(x)});
  }
  roof.triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
  World world(awake());
  addGround(world, roof, 0, 0);
  const Real radius = 0.1, cosine = std::cos(std::numbers::pi / 6), sine = 0.5;
  const Vector3 up(cosine, 0, sine), normal(-sine, 0, cosine);
  const Real way = 1, speed = 6;
  const BodyId ball =
      addBall(world, radius, {.position = -way * up + radius * normal, .velocity = speed * up});
  // way = v t - g sin t^2 / 2 until the foot is at the ridge.
  const Real pull = kGravity * sine;
  const Real leaves = (speed - std::sqrt(speed * speed - 2 * pull * way)) / pull;
  const Real left = speed - pull * leaves;
  const int steps = static_cast<int>(leaves / kStep) + 6;
  run(world, steps);
  const Real flown = steps * kStep - leaves;
  const Vector3 exact =
      radius * normal + flown * left * up - flown * flown / 2 * Vector3(0, 0, kGravity);
  CHECK((world.position(ball) - exact).norm() < 1e-10);
  // It does not fall through the other side.
  run(world, 60);
  const Vector3 place = world.position(ball);
  const Vector3 other(sine, 0, cosine);
  if (place.x() < 4) CHECK(other.dot(place) > radius - 1e-6);
}

TEST_CASE("a slow ball rolls round a ridge and down the other side") {
  TriangleMesh roof;
  for (const Real x : {-4.0, 0.0, 4.0}) {
    for (const Real y : {-2.0, 2.0}) roof.vertices.push_back({x, y, x > 0 ? -0.3 * x : 0});
  }
  roof.triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
  World world(awake());
  addGround(world, roof, 0.8, 0);
  const BodyId ball = addBall(world, 0.5,
                              {.position = {-0.5, 0, 0.5},
                               .velocity = {0.5, 0, 0},
                               .angularVelocity = {0, 1, 0},
                               .friction = 0.8});
  const Vector3 normal = Vector3(0.3, 0, 1).normalized();
  Real least = 1;
  for (int k = 0; k < 150; ++k) {
    world.step(kStep);
    const Vector3 place = world.position(ball);
    if (place.x() > 0.5 && place.x() < 3.5) least = std::min(least, normal.dot(place));
  }
  CHECK(world.position(ball).x() > 1.5);
  CHECK_THAT(least, WithinAbs(0.5, 1e-4));
}

TEST_CASE("a bowl of triangles holds what falls into it") {
  World world(awake());
  addGround(world, shakenSheet(3, 8, 1, [](Real x, Real y) { return 0.4 * std::hypot(x, y); }), 0.5,
            0);
  const BodyId ball = addBall(world, 0.3, {.position = {0.4, 0.5, 1.5}, .friction = 0.5});
  const BodyId box = addBox(world, {0.2, 0.3, 0.1}, {.position = {-1, 0.3, 1.5}, .friction = 0.5});
  run(world, 600);
  for (const BodyId body : {ball, box}) {
    CHECK(world.position(body).z() > 0.05);
    CHECK(world.position(body).z() < 1.5);
  }
}

TEST_CASE("nothing tunnels through a sheet from its front, however fast") {
  for (const Real speed : {50.0, 350.0, 1000.0, 3000.0}) {
    Random random(7);
    World world(weightless());
    addGround(world,
              shakenSheet(3, 8, 5,
                          [](Real x, Real y) { return 0.2 * std::sin(3 * x) * std::cos(2 * y); }),
              0.5, 0);
    for (int i = 0; i < 20; ++i) {
      const Real x = random.between(-1, 1), y = random.between(-1, 1);
      const Vector3 way = (Vector3(0, 0, -1) + random.vector(0.3)).normalized();
      const Real distance = random.between(0.7, 1.5);
      const Vector3 start = Vector3(x, y, 0) - distance * way;
      Thing thing{.position = start, .velocity = speed * way, .friction = 0.5};
      thing.angularVelocity = random.vector(30);
      const BodyId body = i % 3 == 0   ? addBall(world, 0.05, thing)
                          : i % 3 == 1 ? addBox(world, {0.05, 0.04, 0.06}, thing)
                                       : add(world, Capsule{0.04, 0.05}, 1, thing);
      bool below = false;
      for (int k = 0; k < 10; ++k) {
        world.step(kStep);
        const Vector3 p = world.position(body);
        if (std::abs(p.x()) < 2.9 && std::abs(p.y()) < 2.9) {
          // The sheet is the function at its vertices only: this is far below it everywhere.
          below = below || p.z() < -0.25;
        }
      }
      INFO("speed " << speed << ", shot " << i);
      CHECK_FALSE(below);
      world.remove(body);
    }
  }
}

TEST_CASE("what starts behind a sheet falls on") {
  World world(awake());
  addGround(world, flatSheet(5, 4), 0.5, 0);
  const BodyId ball = addBall(world, 0.3, {.position = {0, 0, -0.1}});
  const BodyId deep = addBall(world, 0.3, {.position = {2, 0, -2}, .velocity = {0, 0, 9}});
  run(world, 12);
  CHECK_THAT(world.position(ball).z(), WithinAbs(-0.1 - kGravity * 0.02, 1e-12));
  // From behind it comes through.
  CHECK(world.position(deep).z() < 0);
  run(world, 18);
  CHECK(world.position(deep).z() > -2 + 9 * 0.5 - kGravity / 8 - 1e-9);
}

TEST_CASE("a broken mesh is refused with what is wrong and where, and nothing changes") {
  World world;
  addBall(world, 1, {});
  const std::uint64_t before = world.hash();
  const TriangleMesh good = flatSheet(2, 2);
  const auto refused = [&](const TriangleMesh& mesh, const char* words) {
    CHECK_THROWS_WITH(addGround(world, mesh, 0.5, 0), ContainsSubstring(words));
    CHECK(world.bodyCount() == 1);
    CHECK(world.hash() == before);
  };
  refused({}, "no triangles");
  TriangleMesh bad = good;
  bad.vertices[4].z() = std::numeric_limits<Real>::quiet_NaN();
  refused(bad, "vertex 4 has a coordinate that is not finite");
  bad = good;
  bad.triangles[3][1] = 99;
  refused(bad, "triangle 3 names vertex 99");
  bad = good;
  bad.triangles[2][1] = bad.triangles[2][0];
  refused(bad, "triangle 2");
  bad = good;
  std::swap(bad.triangles[0][0], bad.triangles[0][1]);
  refused(bad, "flipped");
  bad = good;
  bad.triangles.push_back(bad.triangles[1]);
  refused(bad, "flipped");
  bad = good;
  bad.vertices.push_back({0, 0, 3});
  bad.triangles.push_back({bad.triangles[0][1], bad.triangles[0][2], 9});
  refused(bad, "edge");
  BodyDescription moving;
  moving.shapes = {made(Ball{1}, 0, 0)};
  moving.shapes[0].ground = std::make_shared<TriangleMesh>(good);
  CHECK_THROWS_WITH(world.add(moving), ContainsSubstring("immovable"));
}

TEST_CASE("a run over triangles goes on from a snapshot bit by bit") {
  World world;
  addGround(world, shakenSheet(5, 20, 9, [](Real x, Real y) { return 0.3 * std::sin(x + y); }), 0.5,
            0.2);
  Random random(3);
  for (int i = 0; i < 12; ++i) {
    const Vector3 where = random.vector(2) + Vector3(0, 0, 4);
    if (i % 2 == 0) {
      addBall(world, 0.2, {.position = where, .friction = 0.4});
    } else {
      addBox(world, {0.2, 0.3, 0.1}, {.position = where, .friction = 0.4});
    }
  }
  run(world, 60);
  const world::Snapshot snapshot = world.save();
  run(world, 120);
  const std::uint64_t once = world.hash();
  world.restore(snapshot);
  run(world, 120);
  CHECK(world.hash() == once);
  for (const BodyId body : world.bodies()) CHECK(world.position(body).z() > -1);
}

TEST_CASE("far triangles cost a step nothing") {
  const auto counted = [](int cells) {
    World world(awake());
    addGround(world, flatSheet(0.5 * cells, cells), 0.5, 0);
    addBox(world, {0.2, 0.2, 0.2}, {.position = {0.1, 0.2, 0.2}, .friction = 0.5});
    run(world, 5);
    return world.counters();
  };
  const world::Counters few = counted(4), many = counted(64);
  CHECK(many.pairsAwake <= few.pairsAwake + 12);
  CHECK(many.manifoldsMade <= few.manifoldsMade + 12);
  CHECK(many.pairsTested <= few.pairsTested + 40);
}

TEST_CASE("queries find through their tree what they find by looking at every shape") {
  World tree, plain;
  WorldSettings all;
  all.pairFinding = world::PairFinding::allPairs;
  plain.change(all);
  Random random(12);
  const TriangleMesh mesh = shakenSheet(6, 12, 2, [](Real x, Real y) { return 0.2 * x * y / 6; });
  for (World* world : {&tree, &plain}) addGround(*world, mesh, 0.5, 0.3);
  for (World* world : {&tree, &plain}) addPlane(*world, 0.5, 0, {0, 0, 1}, {0, 0, -4});
  std::vector<BodyId> bodies;
  for (int i = 0; i < 60; ++i) {
    const Vector3 where = random.vector(4) + Vector3(0, 0, 6);
    const Real size = random.between(0.1, 0.5);
    BodyId id;
    for (World* world : {&tree, &plain}) {
      id = i % 2 == 0 ? addBall(*world, size, {.position = where, .friction = 0.3})
                      : addBox(*world, {size, 0.2, 0.3}, {.position = where, .friction = 0.3});
    }
    bodies.push_back(id);
  }
  int hits = 0, overlaps = 0, sweeps = 0;
  std::int64_t tested = 0, testedPlain = 0;
  for (int k = 0; k < 40; ++k) {
    // What has been placed, removed or added since the last step is found, too.
    const BodyId placed = bodies[static_cast<std::size_t>(k)];
    const Vector3 there = random.vector(4) + Vector3(0, 0, 6);
    for (World* world : {&tree, &plain}) {
      if (k % 4 == 0) world->place(placed, there, {});
      if (k % 4 == 2) world->remove(placed);
      if (k % 3 == 0) world->step(kStep);
    }
    // The plain world finds its pairs in another way: the same bits all the same.
    REQUIRE(tree.hash() == plain.hash());
    for (int i = 0; i < 20; ++i) {
      Ray ray;
      ray.origin = random.vector(5) + Vector3(0, 0, 4);
      ray.direction = random.direction();
      const auto one = tree.rayCast(ray), other = plain.rayCast(ray);
      tested += tree.queryCounters().shapesTested;
      testedPlain += plain.queryCounters().shapesTested;
      REQUIRE(one.has_value() == other.has_value());
      if (one) {
        CHECK(one->shape == other->shape);
        CHECK(one->time == other->time);
        ++hits;
      }
      Pose pose;
      pose.p_WB = random.vector(4) + Vector3(0, 0, 3);
      const Shape shape = i % 2 == 0 ? Shape(Ball{0.7}) : Shape(Box{{0.4, 0.6, 0.5}});
      const std::vector<BodyId> over = tree.overlap(shape, pose);
      CHECK(over == plain.overlap(shape, pose));
      overlaps += static_cast<int>(over.size());
      const Vector3 velocity = random.vector(5);
      const auto first = tree.sweep(shape, pose, velocity, 1);
      const auto second = plain.sweep(shape, pose, velocity, 1);
      REQUIRE(first.has_value() == second.has_value());
      if (first) {
        CHECK(first->shape == second->shape);
        CHECK(first->time == second->time);
        ++sweeps;
      }
    }
  }
  CHECK(hits > 100);
  CHECK(overlaps > 100);
  CHECK(sweeps > 100);
  CHECK(10 * tested < testedPlain);
}

TEST_CASE("rays, shapes and sweeps meet ground of triangles") {
  World world(awake());
  const BodyId ground = addGround(world, flatSheet(5, 10), 0.5, 0);
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Real x = random.between(-4.9, 4.9), y = random.between(-4.9, 4.9);
    const auto hit = world.rayCast({.origin = {x, y, 3}, .direction = {0, 0, -1}});
    REQUIRE(hit.has_value());
    CHECK(hit->body == ground);
    CHECK_THAT(hit->time, WithinAbs(3, 1e-14));
    CHECK((hit->normal - Vector3::UnitZ()).norm() < 1e-14);
  }
  CHECK_FALSE(world.rayCast({.origin = {6, 0, 3}, .direction = {0, 0, -1}}).has_value());
  Pose there;
  there.p_WB = {0.3, 0.2, 0.4};
  CHECK(world.overlap(Ball{0.41}, there) == std::vector<BodyId>{ground});
  CHECK(world.overlap(Ball{0.39}, there).empty());
  CHECK(world.overlap(Box{{0.1, 0.1, 0.41}}, there) == std::vector<BodyId>{ground});
  const auto swept = world.sweep(Ball{0.1}, there, {1, 0, -2}, 1);
  REQUIRE(swept.has_value());
  CHECK_THAT(swept->time, WithinAbs(0.15, 1e-9));
}
