#include "carom/world/project_velocities.hpp"

#include <algorithm>
#include <cmath>

#include "carom/solver/contact_patch.hpp"
#include "carom/world/contact_phase.hpp"
#include "carom/world/project_positions.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

constexpr Real kMostGap = 1e-3;  // that a long step may open between what is held [m]

bool isHeld(const PairSlot& pair, int point) {
  return pair.force[at(point)] > 0 && pair.manifold.points[at(point)].separation <= kMostGap;
}

void remakeManifolds(WorldState& state, std::span<const Index> pairs, Real end) {
  for (const Index index : pairs) remakeManifold(state, index, end, 0);
}

// Rows of what is held, as it is now.
void listHeld(WorldState& state, std::span<const Index> pairs) {
  Workspace& work = state.work;
  work.patches.clear();
  work.blocks.clear();
  for (const Index index : pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    WorkPatch one = patchOf(state, index);
    if (!pair.sticks) one.patch.friction = 0;
    for (int i = 0; i < pair.manifold.count; ++i) {
      if (isHeld(pair, i)) addPoint(one, i, armsOf(state, pair, i));
    }
    if (one.patch.count == 0) continue;
    work.patches.push_back(one);
    work.blocks.push_back(prepareBlock(one.patch, work.moving));
  }
}

// Stops the rows of a block. Returns how fast the fastest of them was.
Real stopBlock(const ContactBlock& block, std::vector<MovingBody>& bodies) {
  MovingBody &a = bodies[at(block.bodyA)], &b = bodies[at(block.bodyB)];
  Real fastest = 0;
  for (int i = 0; i < block.count; ++i) {
    const Real speed = speedAtEnd(block.normals[at(i)], a, b);
    pushAlong(block.normals[at(i)], -block.masses[at(i)] * speed, a, b);
    if (block.masses[at(i)] > 0) fastest = std::max(fastest, std::abs(speed));
  }
  if (block.rubs == 0) return fastest;
  const Vector3 slip = slipOf(block, bodies);
  const Vector3 impulse = -block.inverse * slip;
  for (int k = 0; k < block.rubs; ++k) {
    pushAlong(block.tangents[at(k)], impulse[k], a, b);
    fastest = std::max(fastest, std::abs(slip[k]));
  }
  return fastest;
}

}  // namespace

void projectEnd(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                Real end) {
  constexpr int kRounds = 3, kSweeps = 40;
  const auto carries = [&](Index index) {
    const PairSlot& pair = state.pairs[at(index)];
    return std::any_of(pair.force.begin(), pair.force.end(), [](Real force) { return force > 0; });
  };
  if (std::none_of(pairs.begin(), pairs.end(), carries)) return;
  remakeManifolds(state, pairs, end);
  for (int round = 0; round < kRounds && state.settings.projectPositions; ++round) {
    if (!projectPositions(state, bodies, pairs, kMostGap)) break;
    remakeManifolds(state, pairs, end);
  }

  gather(state, bodies, pairs);
  listHeld(state, pairs);
  if (state.work.blocks.empty()) return;
  Real speed = 0;
  for (const MovingBody& body : state.work.moving) {
    speed = std::max(speed, body.velocity.linear.norm() + body.velocity.angular.norm());
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    Real fastest = 0;
    for (const ContactBlock& block : state.work.blocks) {
      fastest = std::max(fastest, stopBlock(block, state.work.moving));
    }
    if (fastest <= 4 * std::numeric_limits<Real>::epsilon() * speed) break;
  }
  for (const Index index : bodies) {
    BodySlot& body = state.bodies[at(index)];
    body.velocity = state.work.moving[at(body.local)].velocity;
  }
}

}  // namespace carom::world
