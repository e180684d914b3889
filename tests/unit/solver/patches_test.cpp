// One block, and a few: what friction and pressure must come to.

#include <cmath>
#include <limits>
#include <vector>

#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/passive_impact.hpp"
#include "carom/solver/solve_patches.hpp"
#include "support/catch.hpp"

namespace {

using namespace carom;
using carom_test::WithinAbs;

// A unit cube of 1 kg over the floor, which is body 0.
std::vector<MovingBody> floorAndCube(const Vector3& velocity) {
  std::vector<MovingBody> bodies(2);
  bodies[1].mass.inverseMass = 1;
  bodies[1].mass.inverseInertia = 6 * Matrix3::Identity();
  bodies[1].velocity.linear = velocity;
  return bodies;
}

ContactPatch cubeOnFloor(Real friction) {
  ContactPatch patch;
  patch.bodyA = 0;
  patch.bodyB = 1;
  patch.friction = friction;
  patch.count = 4;
  for (int i = 0; i < 4; ++i) {
    patch.points[static_cast<std::size_t>(i)].armB = {i % 2 == 0 ? -0.5 : 0.5, i < 2 ? -0.5 : 0.5,
                                                      -0.5};
  }
  return patch;
}

const SweepLimits kLimits{.least = 10, .rowBudget = 100'000, .speed = 1};

}  // namespace

TEST_CASE("a cube that comes down flat stops at once, each corner carrying alike") {
  std::vector<MovingBody> bodies = floorAndCube({0, 0, -2});
  std::vector<ContactBlock> blocks = {prepareBlock(cubeOnFloor(0.5), bodies)};
  solvePatches(bodies, blocks, kLimits);
  CHECK(bodies[1].velocity.linear.norm() < 1e-14);
  for (int i = 0; i < 4; ++i) {
    CHECK_THAT(blocks[0].impulses[static_cast<std::size_t>(i)], WithinAbs(0.5, 1e-14));
  }
}

TEST_CASE("points that part are left alone") {
  std::vector<MovingBody> bodies = floorAndCube({0.3, 0, 1});
  std::vector<ContactBlock> blocks = {prepareBlock(cubeOnFloor(0.5), bodies)};
  solvePatches(bodies, blocks, kLimits);
  CHECK(bodies[1].velocity.linear == Vector3(0.3, 0, 1));
}

TEST_CASE("friction of a block is on its cone, against the slip") {
  std::vector<MovingBody> bodies = floorAndCube({3, 4, 0});
  ContactPatch patch = cubeOnFloor(0.25);
  std::vector<ContactBlock> blocks = {prepareBlock(patch, bodies)};
  REQUIRE(blocks[0].slips);
  bodies[1].velocity.linear.z() -= 0.16;
  solvePatches(bodies, blocks, kLimits);
  storeImpulses(blocks[0], patch);
  Real pressed = 0;
  for (int i = 0; i < 4; ++i) pressed += patch.points[static_cast<std::size_t>(i)].impulse;
  CHECK_THAT(pressed, WithinAbs(0.16, 1e-13));
  CHECK((patch.rub - 0.25 * 0.16 * Vector3(-0.6, -0.8, 0)).norm() < 1e-13);
  CHECK(bodies[1].velocity.angular.norm() < 1e-13);
}

TEST_CASE("a slip that would turn round within the step ends at its time") {
  std::vector<MovingBody> bodies = floorAndCube({0.02, 0, 0});
  std::vector<ContactBlock> blocks = {prepareBlock(cubeOnFloor(0.5), bodies)};
  bodies[1].velocity.linear.z() -= 0.16;
  solvePatches(bodies, blocks, kLimits);
  // Braked by 0.08 m/s over the step, from 0.02 m/s.
  CHECK_THAT(stopTime(blocks[0], bodies, 1), WithinAbs(0.25, 1e-12));
}

TEST_CASE("one sticking point without bounce agrees with the impact law of chapter 5") {
  std::vector<MovingBody> bodies = floorAndCube({0.5, -0.2, -1});
  bodies[1].velocity.angular = {0.3, 0.7, -0.4};
  ContactPatch patch = cubeOnFloor(2);
  patch.count = 1;
  patch.slowest = std::numeric_limits<Real>::infinity();
  std::vector<ContactBlock> blocks = {prepareBlock(patch, bodies)};
  std::vector<MovingBody> other = bodies;
  const Contact contact{Vector3::UnitZ(), Vector3::Zero(), patch.points[0].armB};
  const Impact impact =
      passiveImpact(other[0], other[1], contact, {.restitution = 0, .friction = 2});
  REQUIRE(impact.motion == ContactMotion::sticks);
  changeVelocities(other[0], other[1], contact, impact.impulse);
  solvePatches(bodies, blocks, kLimits);
  CHECK((bodies[1].velocity.linear - other[1].velocity.linear).norm() < 1e-12);
  CHECK((bodies[1].velocity.angular - other[1].velocity.angular).norm() < 1e-12);
}
