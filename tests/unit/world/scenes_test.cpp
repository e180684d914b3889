// Motions whose end is known in closed form, at 60 steps a second, sleeping off.

#include <cmath>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/random.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/impulse/bouncing_ball.hpp"
#include "carom/motion/free_rotor.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"

namespace {

using namespace carom_test;

// Generator of the case book.
class CaseRandom {
 public:
  explicit CaseRandom(std::uint64_t seed) : state_(seed) {}
  Real next(int modulus) {
    state_ = 6364136223846793005u * state_ + 1442695040888963407u;
    return static_cast<Real>((state_ >> 33) % static_cast<std::uint64_t>(modulus));
  }

 private:
  std::uint64_t state_;
};

Quaternion aboutY(Real angle) {
  return {std::cos(angle / 2), 0, std::sin(angle / 2), 0};
}

}  // namespace

TEST_CASE("a ball that bounces is where the closed form says, until it rests (A)") {
  World world(awake());
  addPlane(world, 0, 0.8);
  const BodyId ball = addBall(world, 0.5, {.position = {0, 0, 5.5}, .restitution = 0.8});
  Real worst = 0;
  for (int k = 1; k <= 600; ++k) {
    world.step(kStep);
    const BouncingBall exact = bounceBall({5, 0}, {0.8, kGravity}, k * kStep);
    worst = std::max(worst, std::abs(world.position(ball).z() - 0.5 - exact.height));
  }
  CHECK_THAT(worst, WithinAbs(0, 1e-11));
  CHECK(world.velocity(ball).norm() < 1e-12);
}

TEST_CASE("a block slides as far as its speed takes it, and straight on (B)") {
  World world(awake());
  addPlane(world, 0.5, 0);
  const BodyId box = addBox(world, Vector3::Constant(0.5),
                            {.position = {0, 0, 0.5}, .velocity = {5, 0, 0}, .friction = 0.5});
  run(world, 240);
  CHECK_THAT(world.position(box).x(), WithinAbs(25 / kGravity, 1e-12));
  CHECK_THAT(world.position(box).y(), WithinAbs(0, 1e-12));
  CHECK_THAT(world.position(box).z(), WithinAbs(0.5, 1e-12));
  CHECK_THAT(world.orientation(box).z, WithinAbs(0, 1e-12));
  CHECK(world.velocity(box).norm() < 1e-14);
}

TEST_CASE("a hull on six uneven corners slides as far as its speed takes it, and does not spin") {
  // Four of the six corners carry it, and their middle is not below its centre of mass.
  std::vector<Vector3> corners;
  for (const Real z : {0.0, 0.4}) {
    for (const auto& [x, y] :
         {std::pair(0.9, 0.1), {0.4, 0.7}, {-0.5, 0.8}, {-0.9, 0.0}, {-0.4, -0.6}, {0.5, -0.7}}) {
      corners.push_back({x, y, z});
    }
  }
  World world(awake());
  addPlane(world, 0.5, 0);
  const BodyId hull =
      add(world, hullOfPoints(corners), 1, {.velocity = {3, 2, 0}, .friction = 0.5});
  const Vector3 start = world.centre(hull);
  Real spin = 0;
  for (int k = 0; k < 120; ++k) {
    world.step(kStep);
    spin = std::max(spin, world.angularVelocity(hull).norm());
  }
  CHECK(spin < 1e-10);
  const Vector3 way = Vector3(3, 2, 0).normalized() * 13 / kGravity;
  CHECK((world.centre(hull) - start - way).norm() < 1e-9);
  CHECK(world.velocity(hull).norm() < 1e-14);
}

TEST_CASE("a ball that slides begins to roll at its time (C)") {
  World world(awake());
  addPlane(world, 0.3, 0);
  const BodyId ball =
      addBall(world, 0.5, {.position = {0, 0, 0.5}, .velocity = {5, 0, 0}, .friction = 0.3});
  run(world, 300);
  const Real rolls = 10 / (7 * 0.3 * kGravity), v = 25.0 / 7;
  const Real way = 5 * rolls - 0.3 * kGravity * rolls * rolls / 2 + v * (5 - rolls);
  CHECK_THAT(world.velocity(ball).x(), WithinAbs(v, 1e-14));
  CHECK_THAT(world.position(ball).x(), WithinAbs(way, 1e-11));
}

TEST_CASE("a massé shot bends as Coriolis says (case I15)") {
  const Real radius = 0.5;
  World world(awake());
  addPlane(world, 0.2, 0);
  const BodyId ball = addBall(world, radius,
                              {.position = {0, 0, radius},
                               .velocity = {2, 0, 0},
                               .angularVelocity = {-30 / radius, 10 / radius, 0},
                               .friction = 0.2});
  const Real rolls = 4.521384795765261;
  const int whole = static_cast<int>(rolls / kStep);
  run(world, whole);
  world.step(rolls - whole * kStep);
  CHECK_THAT(world.position(ball).x(), WithinAbs(14.21006650097653464956517, 1e-11));
  CHECK_THAT(world.position(ball).y(), WithinAbs(19.37736341042254724940705, 1e-11));
  CHECK_THAT(world.velocity(ball).x(), WithinAbs(30.0 / 7, 1e-12));
  CHECK_THAT(world.velocity(ball).y(), WithinAbs(60.0 / 7, 1e-12));
}

TEST_CASE("Newton's cradle: one ball in, one ball out") {
  World world(weightless());
  std::vector<BodyId> balls;
  for (int i = 0; i < 5; ++i) {
    balls.push_back(addBall(world, 0.5,
                            {.position = {i == 0 ? -1.3 : Real(i), 0, 0},
                             .velocity = {i == 0 ? 2.0 : 0.0, 0, 0},
                             .restitution = 1}));
  }
  run(world, 60);
  for (int i = 0; i < 5; ++i) {
    CHECK_THAT(world.velocity(balls[static_cast<std::size_t>(i)]).x(),
               WithinAbs(i == 4 ? 2 : 0, 1e-12));
  }
}

TEST_CASE("a blow goes on within the step, to balls that the one struck would not have come near") {
  World world(weightless());
  std::vector<BodyId> balls;
  for (int i = 0; i < 5; ++i) {
    balls.push_back(addBall(world, 0.1,
                            {.position = {0.22 * i - (i == 0 ? 0.05 : 0), 0, 0},
                             .velocity = {i == 0 ? 12.0 : 0.0, 0, 0},
                             .restitution = 1}));
  }
  // The blow needs (0.05 + 4 0.02) / 12 s to come through, and the last ball goes on alone.
  world.step(kStep);
  for (int i = 0; i < 5; ++i) {
    CHECK_THAT(world.velocity(balls[static_cast<std::size_t>(i)]).x(),
               WithinAbs(i == 4 ? 12 : 0, 1e-12));
  }
  CHECK_THAT(world.position(balls[4]).x(), WithinAbs(0.88 + 12 * kStep - 0.13, 1e-12));
}

TEST_CASE("216 balls that bounce without loss keep their energy through every blow (case S3)") {
  World world(awake());
  addPlane(world, 0, 1);
  Random random(42);
  for (int i = 0; i < 216; ++i) {
    const Vector3 place(i / 36, i / 6 % 6, i % 6);
    const Vector3 off = random.vector(0.001);
    addBall(world, 0.1,
            {.mass = 10, .position = 0.21 * place + off + Vector3(0, 0, 1.11), .restitution = 1});
  }
  const Real before = world.energy();
  for (int k = 0; k < 300; ++k) {
    world.step(kStep);
    REQUIRE_THAT(world.energy(), WithinRel(before, 1e-13));
  }
}

TEST_CASE("a block on a slope holds or slides, however near the critical angle is") {
  const Real friction = std::tan(0.4);
  for (const Real beyond : {-1e-6, 1e-6, 1e-2}) {
    const Real angle = 0.4 + beyond;
    const Vector3 normal(std::sin(angle), 0, std::cos(angle));
    World world(awake());
    addPlane(world, friction, 0, normal);
    const BodyId box =
        addBox(world, Vector3::Constant(0.5),
               {.position = 0.5 * normal, .orientation = aboutY(angle), .friction = friction});
    run(world, 600);
    const Real way = (world.position(box) - 0.5 * normal).norm();
    const Real pull = kGravity * (std::sin(angle) - friction * std::cos(angle));
    INFO("beyond the critical angle by " << beyond);
    if (beyond < 0) CHECK(way < 1e-12);
    if (beyond > 0) CHECK_THAT(way, WithinRel(50 * pull, 1e-8));
  }
}

TEST_CASE("a free body tumbles for 100 s as in closed form (F)") {
  World world(weightless());
  const BodyId box =
      addBox(world, {0.5, 1, 1.5}, {.mass = 6000, .angularVelocity = {0.01, 5, 0.01}});
  const FreeRotor rotor(world.inertia(box).diagonal(), {Quaternion{}, Vector3(0.01, 5, 0.01)});
  const Vector3 momentum = world.angularMomentum();
  run(world, 6000);
  const Matrix3 turned = quaternionToMatrix(world.orientation(box));
  const Matrix3 exact = quaternionToMatrix(rotor.at(6000 * kStep).q_WB);
  CHECK((turned - exact).norm() < 1e-10);
  CHECK((world.angularMomentum() - momentum).norm() < 1e-13 * momentum.norm());
}

TEST_CASE("no speed tunnels through a thin wall, and nothing stays inside it (J)") {
  for (const Real speed : {50.0, 350.0, 1000.0, 3000.0}) {
    Random random(7);
    for (int i = 0; i < 25; ++i) {
      World world(weightless());
      BodyDescription wall;
      wall.kind = BodyKind::immovable;
      wall.shapes = {made(Box{{0.01, 2, 2}}, 0.5, 0)};
      world.add(wall);
      const Real y = random.between(-0.5, 0.5), z = random.between(-0.5, 0.5);
      const Vector3 way = (Vector3(1, 0, 0) + random.vector(0.3)).normalized();
      const Real distance = random.between(0.2, 1.2);
      const BodyId ball = addBall(world, 0.05,
                                  {.position = Vector3(0, y, z) - distance * way,
                                   .velocity = speed * way,
                                   .friction = 0.5});
      run(world, 10);
      INFO("speed " << speed << ", shot " << i);
      CHECK(world.position(ball).x() < -0.06 + 1e-9);
    }
  }
}

TEST_CASE("far from the origin a block slides as far as at it (M)") {
  World world(awake());
  addPlane(world, 0.5, 0);
  const BodyId box = addBox(world, Vector3::Constant(0.5),
                            {.position = {1e6, 0, 0.5}, .velocity = {5, 0, 0}, .friction = 0.5});
  run(world, 240);
  CHECK_THAT(world.position(box).x() - 1e6, WithinAbs(25 / kGravity, 1e-8));
}

TEST_CASE("49 elastic balls keep their energy for 20 s (case S2)") {
  World world(awake());
  addPlane(world, 0, 1);
  std::vector<BodyId> balls;
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) {
      balls.push_back(
          addBall(world, 0.1, {.mass = 10, .position = {0.5 * i, 0.5 * j, 5}, .restitution = 1}));
    }
  }
  const Real before = world.energy();
  CHECK_THAT(before, WithinRel(24034.5, 1e-12));
  const Real dt = 0.01;
  run(world, 2000, dt);
  CHECK_THAT(world.energy(), WithinAbs(before, 1e-8));
  for (const BodyId ball : balls) {
    CHECK_THAT(world.position(ball).z(), WithinAbs(4.99949005606067786572522, 1e-11));
    CHECK_THAT(world.velocity(ball).z(), WithinAbs(-0.100025497196966106713739, 1e-11));
  }
}

TEST_CASE("eight hard spheres in a box follow the exact events (case S8)") {
  World world(weightless());
  for (int axis = 0; axis < 3; ++axis) {
    addPlane(world, 0, 1, Vector3::Unit(axis), Vector3::Zero());
    addPlane(world, 0, 1, -Vector3::Unit(axis), Vector3::Ones());
  }
  CaseRandom random(3);
  std::vector<BodyId> balls;
  for (int i = 0; i < 8; ++i) {
    const Vector3 cell(i / 4, i / 2 % 2, i % 2);
    Thing thing{.restitution = 1};
    for (int k = 0; k < 3; ++k) {
      thing.position[k] = (2 * cell[k] + 1) / 4 + (random.next(1001) - 500) / 20000;
    }
    for (int k = 0; k < 3; ++k) thing.velocity[k] = (random.next(2001) - 1000) / 1000;
    balls.push_back(addBall(world, 0.1, thing));
  }
  const Real before = world.energy();
  CHECK_THAT(before, WithinRel(5.1737005, 1e-13));
  run(world, 30);
  CHECK((world.position(balls[0]) - Vector3(0.14575, 0.1262, 0.72305)).norm() < 1e-13);
  run(world, 30);
  CHECK((world.position(balls[0]) - Vector3(0.32575, 0.1778, 0.58445)).norm() < 1e-13);
  run(world, 60);
  const Vector3 exact(0.6967717795782890532674245, 0.1316839224754545509147152,
                      0.4127023720863301793457006);
  CHECK((world.position(balls[0]) - exact).norm() < 1e-11);
  run(world, 360);
  CHECK_THAT(world.energy(), WithinRel(before, 1e-13));
}

TEST_CASE("a tennis ball on a basketball goes up nine times as high (case S9)") {
  for (const Real ratio : {3.0, 10.0, 1000.0}) {
    World world(awake());
    addPlane(world, 0, 1);
    addBall(world, 0.1, {.mass = ratio, .position = {0, 0, 1.1}, .restitution = 1});
    const BodyId small = addBall(world, 0.02, {.position = {0, 0, 1.22}, .restitution = 1});
    Real top = 0;
    for (int k = 0; k < 60; ++k) {
      world.step(kStep);
      const Real up = world.velocity(small).z();
      if (up > 0) {
        top = std::max(top, world.position(small).z() - 0.22 + up * up / (2 * kGravity));
      }
    }
    const Real factor = (3 * ratio - 1) / (ratio + 1);
    CHECK_THAT(top, WithinRel(factor * factor, 1e-10));
  }
}

TEST_CASE("a domino falls about its edge (case S7)") {
  World world(awake());
  addPlane(world, 5, 0);
  const BodyId domino = addBox(world, {0.1, 0.25, 0.5}, {.position = {0, 0, 0.5}, .friction = 5});
  const Vector3 rate(0, 1.2, 0);
  world.setVelocity(domino, cross(rate, Vector3(-0.1, 0, 0.5)), rate);
  const Real dt = 1.0 / 960, hit = 0.5235987755982988730771072;
  Real before = 0, time = 0;
  for (;; time += dt) {
    world.step(dt);
    const Quaternion q = world.orientation(domino);
    const Real angle = 2 * std::atan2(q.y, q.w);
    if (angle >= hit) {
      // Back from the end of the step, where angle, rate and acceleration are known.
      const Real w = world.angularVelocity(domino).y();
      const Real pull = 0.75 * kGravity / std::hypot(0.1, 0.5) * std::sin(angle - std::atan(0.2));
      Real back = 0;
      for (int i = 0; i < 20; ++i) back = (hit - angle - pull * back * back / 2) / w;
      time += dt + back;
      break;
    }
    REQUIRE(angle >= before);
    before = angle;
  }
  CHECK_THAT(time, WithinAbs(0.4802677801783503492976047, 1e-6));
}

TEST_CASE("a block rocks from edge to edge and loses what Housner says (case S10)") {
  const Real alpha = std::atan(0.2);
  const Quaternion tilted = aboutY(alpha / 2);
  const Vector3 edge(0.2, 0, -1);
  World world(awake());
  addPlane(world, 5, 0);
  const BodyId block = addBox(
      world, {0.2, 0.5, 1},
      {.position = -(quaternionToMatrix(tilted) * edge), .orientation = tilted, .friction = 5});
  Real least = 0;
  for (int k = 0; k < 1200; ++k) {
    world.step(1.0 / 960);
    const Quaternion q = world.orientation(block);
    least = std::min(least, 2 * std::atan2(q.y, q.w));
  }
  CHECK_THAT(-least, WithinAbs(0.08333911316435468816924753, 1e-6));
}
