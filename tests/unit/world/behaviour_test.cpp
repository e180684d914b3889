// What a world does beside moving: ids, errors, islands, sleep, events, queries, snapshots.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"

namespace {

using namespace carom_test;
using carom_test::add;

// A floor and some boxes on it, side by side.
std::vector<BodyId> boxesOnFloor(World& world, int count) {
  addPlane(world, 0.5, 0);
  std::vector<BodyId> boxes;
  for (int i = 0; i < count; ++i) {
    boxes.push_back(
        addBox(world, Vector3::Constant(0.5), {.position = {1.5 * i, 0, 0.5}, .friction = 0.5}));
  }
  return boxes;
}

std::vector<BodyId> towerOnFloor(World& world, int count) {
  addPlane(world, 0.5, 0);
  std::vector<BodyId> boxes;
  for (int i = 0; i < count; ++i) {
    boxes.push_back(
        addBox(world, Vector3::Constant(0.5), {.position = {0, 0, 0.5 + i}, .friction = 0.5}));
  }
  return boxes;
}

bool inside(const std::vector<BodyId>& list, BodyId id) {
  return std::find(list.begin(), list.end(), id) != list.end();
}

}  // namespace

TEST_CASE("a world refuses what no body can be, and stays as it was") {
  World world;
  const BodyId ball = addBall(world, 1, {.position = {0, 0, 5}});
  const std::uint64_t before = world.hash();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();

  BodyDescription body;
  body.shapes = {made(Ball{1}, 0.5, 0)};
  const auto refused = [&](const BodyDescription& bad, const char* words) {
    CHECK_THROWS_WITH(world.add(bad), ContainsSubstring(words));
  };
  BodyDescription bad = body;
  bad.mass = MassProperties{1, -2, Vector3::Zero(), Matrix3::Identity()};
  refused(bad, "mass = -2 must be positive");
  bad.mass = MassProperties{1, 1, Vector3::Zero(), -Matrix3::Identity()};
  refused(bad, "inertia");
  bad = body;
  bad.position.x() = nan;
  refused(bad, "position");
  bad = body;
  bad.velocity.y() = nan;
  refused(bad, "velocity");
  bad = body;
  bad.orientation = {2, 0, 0, 0};
  refused(bad, "quaternion of norm one");
  bad = body;
  bad.shapes[0].shape = Ball{0};
  refused(bad, "0 must be positive");
  bad = body;
  bad.shapes[0].material.friction = -1;
  refused(bad, "friction = -1");
  bad = body;
  bad.shapes[0].material.restitution = 1.5;
  refused(bad, "1.5");
  bad = body;
  bad.shapes[0].density = 0;
  refused(bad, "density = 0");
  bad = body;
  bad.shapes[0].shape = HalfSpace{};
  refused(bad, "half-space");
  bad.shapes.clear();
  refused(bad, "needs a mass");

  CHECK_THROWS_WITH(world.step(0), ContainsSubstring("dt = 0 must be positive"));
  CHECK_THROWS_WITH(world.step(-1), ContainsSubstring("dt = -1"));
  CHECK_THROWS_WITH(world.step(nan), ContainsSubstring("dt = "));
  CHECK_THROWS_AS(world.push(ball, {nan, 0, 0}, {0, 0, 0}), InvalidInput);
  CHECK_THROWS_AS(world.place(ball, {0, nan, 0}, {}), InvalidInput);
  CHECK_THROWS_AS(world.setVelocity(ball, {0, 0, 0}, {0, nan, 0}), InvalidInput);
  WorldSettings settings;
  settings.iterations = 0;
  CHECK_THROWS_WITH(world.change(settings), ContainsSubstring("iterations = 0"));
  settings = WorldSettings();
  settings.gravity.z() = nan;
  CHECK_THROWS_AS(World(settings), InvalidInput);
  CHECK(world.hash() == before);
  CHECK(world.bodyCount() == 1);
}

TEST_CASE("a world takes no more bodies than its settings allow") {
  WorldSettings settings;
  settings.maxBodies = 2;
  World world(settings);
  addBall(world, 1, {});
  addBall(world, 1, {.position = {5, 0, 0}});
  CHECK_THROWS_WITH(addBall(world, 1, {.position = {9, 0, 0}}), ContainsSubstring("at most the 2"));
  CHECK(world.bodyCount() == 2);
}

TEST_CASE("the id of a removed body names nobody, also when its place is taken again") {
  World world;
  const BodyId first = addBall(world, 1, {});
  world.remove(first);
  const BodyId second = addBall(world, 1, {});
  CHECK(second.index == first.index);
  CHECK_FALSE(world.contains(first));
  CHECK(world.contains(second));
  CHECK_THROWS_WITH(world.position(first), ContainsSubstring("names no body"));
  CHECK_THROWS_AS(world.remove(first), InvalidInput);
  CHECK_THROWS_AS(world.position(BodyId{}), InvalidInput);
}

TEST_CASE("boxes at rest fall asleep, and then cost nothing") {
  World world;
  const std::vector<BodyId> boxes = boxesOnFloor(world, 10);
  run(world, 60);
  for (const BodyId box : boxes) CHECK(world.asleep(box));
  world.step(kStep);
  CHECK(world.counters().bodiesAwake == 0);
  CHECK(world.counters().bodiesAsleep == 10);
  CHECK(world.counters().islandsAwake == 0);
  CHECK(world.counters().pairsAwake == 0);
  CHECK(world.counters().manifoldsMade == 0);
  CHECK(world.counters().rowsSolved == 0);
}

TEST_CASE("a push wakes the tower that it hits, and not the one beside it") {
  World world;
  addPlane(world, 0.5, 0);
  std::vector<BodyId> towers[2];
  for (int t = 0; t < 2; ++t) {
    for (int i = 0; i < 3; ++i) {
      towers[t].push_back(addBox(world, Vector3::Constant(0.5),
                                 {.position = {3.0 * t, 0, 0.5 + i}, .friction = 0.5}));
    }
  }
  run(world, 60);
  CHECK(world.asleep(towers[0][0]));
  CHECK(world.asleep(towers[1][2]));
  world.push(towers[0][2], {0.01, 0, 0}, world.centre(towers[0][2]));
  for (const BodyId box : towers[0]) CHECK_FALSE(world.asleep(box));
  for (const BodyId box : towers[1]) CHECK(world.asleep(box));
}

TEST_CASE("what stood on a body that is removed wakes and falls") {
  World world;
  const std::vector<BodyId> tower = towerOnFloor(world, 3);
  run(world, 60);
  CHECK(world.asleep(tower[2]));
  world.remove(tower[0]);
  CHECK_FALSE(world.asleep(tower[2]));
  run(world, 120);
  CHECK_THAT(world.position(tower[2]).z(), WithinAbs(1.5, 1e-6));
}

TEST_CASE("a ball that falls on a sleeping box wakes it") {
  World world;
  const BodyId box = boxesOnFloor(world, 1)[0];
  run(world, 60);
  REQUIRE(world.asleep(box));
  addBall(world, 0.2, {.position = {0, 0, 1.5}});
  run(world, 20);
  CHECK_FALSE(world.asleep(box));
}

TEST_CASE("a box that begins to tip does not fall asleep, however slow it is") {
  World world;
  addPlane(world, 5, 0);
  // On its edge, a millionth of a radian from where it would stand for ever.
  const Real angle = std::atan(0.2) + 1e-6;
  const Quaternion tilted{std::cos(angle / 2), 0, std::sin(angle / 2), 0};
  const Vector3 edge(0.2, 0, -1);
  const Vector3 turned(std::cos(angle) * edge.x() + std::sin(angle) * edge.z(), 0,
                       -std::sin(angle) * edge.x() + std::cos(angle) * edge.z());
  const BodyId block =
      addBox(world, {0.2, 0.5, 1}, {.position = -turned, .orientation = tilted, .friction = 5});
  for (int k = 0; k < 500 && world.position(block).z() > 0.5; ++k) world.step(kStep);
  CHECK(world.position(block).z() < 0.5);
}

TEST_CASE("a ball at the top of its flight does not fall asleep") {
  World world;
  const BodyId ball = addBall(world, 0.5, {.velocity = {0, 0, 2}});
  run(world, 60);
  CHECK_FALSE(world.asleep(ball));
  CHECK_THAT(world.position(ball).z(), WithinAbs(2 - kGravity / 2, 1e-12));
}

TEST_CASE("contacts begin, strike and end, and the world tells") {
  World world(awake());
  const BodyId floor = addPlane(world, 0, 1);
  const BodyId ball = addBall(world, 0.5, {.position = {0, 0, 0.6}, .restitution = 1});
  int begun = 0, ended = 0, struck = 0;
  for (int k = 0; k < 30; ++k) {
    world.step(kStep);
    const world::Events events = world.events();
    begun += static_cast<int>(events.begun.size());
    ended += static_cast<int>(events.ended.size());
    for (const world::ImpactEvent& impact : events.impacts) {
      ++struck;
      CHECK(impact.bodyA == floor);
      CHECK(impact.bodyB == ball);
      CHECK_THAT(impact.approach, WithinRel(std::sqrt(2 * kGravity * 0.1), 1e-12));
      CHECK_THAT(impact.impulse, WithinRel(2 * impact.approach, 1e-12));
      CHECK_THAT(impact.normal.z(), WithinAbs(1, 1e-15));
    }
  }
  CHECK(struck == 2);
  CHECK(begun == 2);
  CHECK(ended == 2);
}

TEST_CASE("filters keep shapes apart") {
  World world(awake());
  addPlane(world, 0, 0);
  BodyDescription ghost;
  ghost.position = {0, 0, 1};
  ghost.shapes = {made(Ball{0.5}, 0, 0)};
  ghost.shapes[0].filter.mask = 0;
  const BodyId falls = world.add(ghost);
  run(world, 60);
  CHECK_THAT(world.position(falls).z(), WithinAbs(1 - kGravity / 2, 1e-12));
}

TEST_CASE("a kinematic lift carries a box, and nothing stops it") {
  World world(awake());
  BodyDescription lift;
  lift.kind = BodyKind::kinematic;
  lift.velocity = {0, 0, 0.5};
  lift.shapes = {made(Box{{2, 2, 0.1}}, 0.5, 0)};
  const BodyId platform = world.add(lift);
  const BodyId box = addBox(world, Vector3::Constant(0.5),
                            {.position = {0, 0, 0.6}, .velocity = {0, 0, 0.5}, .friction = 0.5});
  run(world, 60);
  CHECK_THAT(world.position(platform).z(), WithinAbs(0.5, 1e-13));
  CHECK_THAT(world.position(box).z(), WithinAbs(1.1, 1e-9));
}

TEST_CASE("rays, boxes and moving shapes find what is there") {
  World world(awake());
  const BodyId near = addBall(world, 0.5, {.position = {3, 0, 0}});
  const BodyId far = addBall(world, 0.5, {.position = {6, 0, 0}});
  const auto hit = world.rayCast({.origin = {0, 0, 0}, .direction = {1, 0, 0}});
  REQUIRE(hit.has_value());
  CHECK(hit->body == near);
  CHECK_THAT(hit->time, WithinAbs(2.5, 1e-14));
  CHECK_FALSE(world.rayCast({.origin = {0, 2, 0}, .direction = {1, 0, 0}}).has_value());
  Pose there;
  there.p_WB = {4.5, 0, 0};
  const std::vector<BodyId> both = world.overlap(Ball{1.1}, there);
  CHECK(both == std::vector<BodyId>{near, far});
  CHECK(world.overlap(Ball{0.9}, there).empty());
  const auto swept = world.sweep(Ball{0.25}, Pose{}, {2, 0, 0}, 5);
  REQUIRE(swept.has_value());
  CHECK(swept->body == near);
  CHECK_THAT(swept->time, WithinAbs(1.125, 1e-9));
}

TEST_CASE("a run goes on from a snapshot bit by bit") {
  World world;
  towerOnFloor(world, 3);
  Random random(5);
  for (int i = 0; i < 8; ++i) {
    const Vector3 where = random.vector(2);
    addBall(world, 0.2,
            {.position = where + Vector3(0, 0, 5), .friction = 0.3, .restitution = 0.5});
  }
  run(world, 40);
  const world::Snapshot snapshot = world.save();
  run(world, 60);
  const std::uint64_t once = world.hash();
  world.restore(snapshot);
  run(world, 60);
  CHECK(world.hash() == once);
  World other;
  other.restore(snapshot);
  run(other, 60);
  CHECK(other.hash() == once);
  CHECK_THROWS_AS(world.restore(world::Snapshot{}), InvalidInput);
}

TEST_CASE("all pairs, compared one by one, are counted, and give the same motion as the tree") {
  const auto endOf = [](world::PairFinding finding, std::int64_t& tested) {
    WorldSettings settings = awake();
    settings.pairFinding = finding;
    World world(settings);
    addPlane(world, 0.5, 0.5);
    for (int i = 0; i < 6; ++i) {
      addBall(world, 0.2,
              {.position = {1.0 * i, 0, 0.5 + 0.1 * i}, .friction = 0.5, .restitution = 0.5});
    }
    run(world, 30);
    tested = world.counters().pairsTested;
    return world.hash();
  };
  std::int64_t byTree = 0, byAll = 0;
  CHECK(endOf(world::PairFinding::tree, byTree) == endOf(world::PairFinding::allPairs, byAll));
  CHECK(byAll == 6 * 7 / 2);
}

TEST_CASE("the order in which independent islands were added changes no bit") {
  const auto hashOf = [](bool reversed) {
    World world;
    const auto build = [&](int which) {
      const Real x = 20.0 * which;
      for (int i = 0; i < 3; ++i) {
        addBox(world, Vector3::Constant(0.5),
               {.position = {x + 0.1 * i, 0.02 * which, 0.6 + 1.1 * i}, .friction = 0.5});
      }
      addBall(
          world, 0.3,
          {.position = {x - 3, 0, 1}, .velocity = {4, 0, 0}, .friction = 0.2, .restitution = 0.4});
    };
    if (reversed) {
      build(1), build(0);
      addPlane(world, 0.5, 0);
    } else {
      addPlane(world, 0.5, 0);
      build(0), build(1);
    }
    run(world, 120);
    return world.hash();
  };
  CHECK(hashOf(false) == hashOf(true));
}

TEST_CASE("a scene of balls builds no separating axis, a smooth one no rows of friction") {
  World world(awake());
  addPlane(world, 0, 0.5);
  Random random(3);
  for (int i = 0; i < 30; ++i) {
    const Vector3 off = random.vector(0.05);
    addBall(world, 0.2, {.position = off + Vector3(i % 5 * 0.35, i / 5 % 3 * 0.35, 1 + i / 15)});
  }
  std::int64_t axes = 0, rubs = 0, normals = 0;
  for (int k = 0; k < 120; ++k) {
    world.step(kStep);
    axes += world.counters().axesSearches;
    rubs += world.counters().frictionRows;
    normals += world.counters().normalRows;
  }
  CHECK(axes == 0);
  CHECK(rubs == 0);
  CHECK(normals > 0);
}

TEST_CASE("a tower of ten stands for ten seconds as if it were one") {
  World world(awake());
  const std::vector<BodyId> tower = towerOnFloor(world, 10);
  run(world, 600);
  CHECK((world.position(tower[9]) - Vector3(0, 0, 9.5)).norm() < 1e-9);
  CHECK(world.velocity(tower[9]).norm() < 1e-9);
}

TEST_CASE("a tower of forty stands to the last bit, and moves when its top is pushed") {
  World world(awake());
  const std::vector<BodyId> tower = towerOnFloor(world, 40);
  world.step(kStep);
  CHECK(world.counters().islandsDirect == 1);
  run(world, 120);
  CHECK(world.position(tower[39]) == Vector3(0, 0, 39.5));
  CHECK(world.velocity(tower[39]) == Vector3(0, 0, 0));
  world.push(tower[39], {3, 0, 0}, world.centre(tower[39]));
  run(world, 30);
  CHECK(world.position(tower[39]).x() > 0.05);
}

TEST_CASE("a box stands on one that is ten thousand times lighter") {
  World world(awake());
  addPlane(world, 0.5, 0);
  addBox(world, Vector3::Constant(0.5), {.position = {0, 0, 0.5}, .friction = 0.5});
  const BodyId heavy = addBox(world, Vector3::Constant(0.5),
                              {.mass = 1e4, .position = {0, 0, 1.5}, .friction = 0.5});
  run(world, 600);
  CHECK((world.position(heavy) - Vector3(0, 0, 1.5)).norm() < 1e-9);
}

TEST_CASE("thousands of calls in any order never break a world") {
  Random random(11);
  World world;
  addPlane(world, 0.5, 0.2);
  std::vector<BodyId> alive;
  world::Snapshot kept = world.save();
  std::vector<BodyId> keptAlive;
  const auto any = [&]() -> BodyId {
    return alive[static_cast<std::size_t>(random.integer(0, static_cast<int>(alive.size()) - 1))];
  };
  for (int call = 0; call < 4000; ++call) {
    const int what = random.integer(0, 11);
    const Vector3 v = random.vector(3);
    if (what <= 2 && alive.size() < 40) {
      const Vector3 where = v + Vector3(0, 0, 4);
      Thing thing{
          .position = where, .velocity = random.vector(5), .friction = 0.4, .restitution = 0.3};
      const Real size = random.between(0.1, 0.5);
      alive.push_back(random.integer(0, 1) == 0 ? addBall(world, size, thing)
                                                : addBox(world, {size, 0.3, 0.2}, thing));
    } else if (what == 3 && !alive.empty()) {
      const BodyId gone = any();
      world.remove(gone);
      alive.erase(std::find(alive.begin(), alive.end(), gone));
      CHECK_THROWS_AS(world.velocity(gone), InvalidInput);
    } else if (what == 4 && !alive.empty()) {
      world.push(any(), v, v);
    } else if (what == 5 && !alive.empty()) {
      world.setVelocity(any(), v, random.vector(4));
    } else if (what == 6 && !alive.empty()) {
      world.place(any(), v + Vector3(0, 0, 4), {});
    } else if (what == 7 && !alive.empty()) {
      world.setForce(any(), v);
    } else if (what == 8) {
      world.rayCast({.origin = v + Vector3(0, 0, 9), .direction = {0.1, 0.1, -1}});
      world.overlap(Ball{0.5}, Pose{});
    } else if (what == 9 && call % 7 == 0) {
      kept = world.save();
      keptAlive = alive;
    } else if (what == 10 && call % 11 == 0) {
      world.restore(kept);
      alive = keptAlive;
    } else {
      world.step(kStep);
    }
  }
  CHECK(world.bodyCount() == static_cast<int>(alive.size()) + 1);
  for (const BodyId body : alive) {
    CHECK(world.position(body).allFinite());
    CHECK(world.velocity(body).allFinite());
    CHECK(inside(world.bodies(), body));
  }
}

TEST_CASE("a ball that nothing rubs is not turned by blows, not even by rounding") {
  for (const Real friction : {0.0, 0.3}) {
    World world(weightless());
    const BodyId moving = addBall(world, 0.3,
                                  {.position = {-1, 0.21, 0.13},
                                   .velocity = {7, 0.1, 0.3},
                                   .friction = friction,
                                   .restitution = 1});
    const BodyId struck =
        addBall(world, 0.3, {.position = {0, 0, 0}, .friction = friction, .restitution = 1});
    run(world, 30);
    CHECK(world.velocity(struck).norm() > 1);
    for (const BodyId ball : {moving, struck}) {
      CHECK((world.angularVelocity(ball) == Vector3::Zero()) == (friction == 0));
    }
  }
}

TEST_CASE("balls that pass each other are not looked at, whoever a blow turns aside is") {
  using namespace carom_test;
  const bool struck = GENERATE(false, true);
  CAPTURE(struck);
  World world(weightless());
  // The first goes along x, far beside the third; the second turns it towards that.
  const BodyId first =
      addBall(world, 0.1, {.position = {0, 0, 0}, .velocity = {5, 0, 0}, .restitution = 1});
  if (struck) addBall(world, 0.1, {.position = {0.35, -0.14, 0}, .restitution = 1});
  const BodyId third = addBall(world, 0.1, {.position = {0.3, 0.3, 0}, .restitution = 1});
  world.step(0.1);
  // Their boxes meet, for a blow might send the first anywhere.
  CHECK(world.counters().pairsAwake == (struck ? 3 : 1));
  CHECK(world.counters().impacts == (struck ? 2 : 0));
  CHECK((world.velocity(third).norm() > 0.1) == struck);
  if (!struck) {
    CHECK(world.counters().manifoldsMade == 0);
    CHECK((world.position(first) - Vector3(0.5, 0, 0)).norm() < 1e-15);
  }
}

TEST_CASE("who is struck by a paddle that only spins sees his next neighbour") {
  using namespace carom_test;
  World world(weightless());
  const Box blade{Vector3(0.5, 0.05, 0.05)};
  BodyDescription paddle;
  paddle.kind = BodyKind::kinematic;
  paddle.angularVelocity = {0, 0, 30};
  paddle.shapes = {made(blade, 0, 1)};
  world.add(paddle);
  // The blade is there after half of the step, and throws the one at the other.
  const Vector3 struck(0.4, 0.25, 0), beyond(0.33, 0.54, 0);
  const BodyId first = addBall(world, 0.1, {.position = struck, .restitution = 1});
  const BodyId second = addBall(world, 0.1, {.position = beyond, .restitution = 1});
  world.step(kStep);
  CHECK(world.counters().impacts >= 2);
  CHECK(world.velocity(second).norm() > 10);
  CHECK((world.position(second) - world.position(first)).norm() > 0.2 - 1e-9);
}
