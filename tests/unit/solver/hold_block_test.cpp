// One block that sticks, solved at once: what sweeps tend to, or nothing.

#include <vector>

#include "carom/core/random.hpp"
#include "carom/solver/hold_block.hpp"
#include "carom/solver/solve_patches.hpp"
#include "support/catch.hpp"

namespace {

using namespace carom;

// A body of 1 kg at the origin, over the floor, which is body 0.
std::vector<MovingBody> floorAndBody(const Velocity& velocity) {
  std::vector<MovingBody> bodies(2);
  bodies[1].mass.inverseMass = 1;
  bodies[1].mass.inverseInertia = Vector3(5, 6, 8).asDiagonal();
  bodies[1].velocity = velocity;
  return bodies;
}

// A tip, an edge along y, a triangle or a face, half a metre below the body.
ContactPatch patchOf(int count, Real friction) {
  ContactPatch patch;
  patch.bodyB = 1;
  patch.friction = friction;
  patch.slowest = std::numeric_limits<Real>::infinity();
  patch.count = count;
  const Vector3 corners[] = {
      {0.3, -0.2, -0.5}, {0.3, 0.2, -0.5}, {-0.4, 0.2, -0.5}, {-0.4, -0.2, -0.5}};
  for (int i = 0; i < count; ++i) patch.points[static_cast<std::size_t>(i)].armB = corners[i];
  return patch;
}

Velocity random(Random& random) {
  const Vector3 linear = random.vector(0.1) - Vector3(0, 0, 1);
  const Vector3 angular = random.vector(0.1);
  return {linear, angular};
}

}  // namespace

TEST_CASE("tips, edges and faces that stick are held as sweeps would hold them") {
  Random numbers(1);
  int held = 0;
  for (int count = 1; count <= 4; ++count) {
    for (const Real friction : {Real(0), Real(100)}) {
      for (int n = 0; n < 50; ++n) {
        std::vector<MovingBody> bodies = floorAndBody(random(numbers)), swept = bodies;
        ContactPatch patch = patchOf(count, friction);
        // Four points cannot part as they like.
        if (count < 4) patch.points[0].target = 0.01;
        std::vector<ContactBlock> blocks{prepareBlock(patch, bodies)}, others = blocks;
        solvePatches(swept, others, {.least = 10, .rowBudget = 100'000, .speed = 1});
        const std::vector<MovingBody> before = bodies;
        if (!holdBlock(bodies, blocks[0])) {
          CHECK(bodies[1].velocity.linear == before[1].velocity.linear);
          CHECK(bodies[1].velocity.angular == before[1].velocity.angular);
          CHECK(blocks[0].rub == Vector3::Zero());
          continue;
        }
        ++held;
        CHECK((bodies[1].velocity.linear - swept[1].velocity.linear).norm() < 1e-9);
        CHECK((bodies[1].velocity.angular - swept[1].velocity.angular).norm() < 1e-9);
        CHECK(slipOf(blocks[0], bodies).norm() < 1e-13);
      }
    }
  }
  CHECK(held > 100);
}

TEST_CASE("what slips, parts or would leave the cone is not held") {
  const Velocity falls{Vector3(0.3, 0, -1), Vector3::Zero()};
  const auto isHeld = [](const Velocity& velocity, ContactPatch patch) {
    std::vector<MovingBody> bodies = floorAndBody(velocity);
    ContactBlock block = prepareBlock(patch, bodies);
    const bool held = holdBlock(bodies, block);
    CHECK(held == (bodies[1].velocity.linear != velocity.linear));
    return held;
  };
  CHECK(isHeld(falls, patchOf(4, 1)));
  ContactPatch slips = patchOf(4, 1);
  slips.slowest = 0;
  CHECK_FALSE(isHeld(falls, slips));
  CHECK_FALSE(isHeld(falls, patchOf(4, 0.1)));
  CHECK_FALSE(isHeld({Vector3(0, 0, 1), Vector3::Zero()}, patchOf(4, 1)));
  // It tips over its edge, and the corners on the other side let go.
  CHECK_FALSE(isHeld({Vector3::Zero(), Vector3(0, 1, 0)}, patchOf(4, 1)));
}
