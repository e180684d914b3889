#include "carom/world/project_positions.hpp"

#include <algorithm>
#include <cmath>

#include "carom/rotation/integrate_orientation.hpp"
#include "carom/solver/contact_patch.hpp"
#include "carom/solver/soft_steps.hpp"
#include "carom/world/contact_phase.hpp"
#include "carom/world/keep_energy.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

// How far a point should move along the normal in this step; zero for most of them. One that
// carries is closed again if it has come off by less than a gap.
Real wantedWay(const WorldState& state, const PairSlot& pair, int point, Real gap) {
  // Deeper overlaps than this come apart over several steps, lest bodies jump, small ones neither: as
  // soft steps take them apart, at so much speed for each unit of depth. Where nobody looks inside of
  // steps bodies lie in each other all the time, and come apart faster.
  constexpr Real kAtOnce = 1e-4, kOfSize = 1e-3, kMost = 0.2;
  const WorldSettings& settings = state.settings;
  const Real atOnce = std::min(kAtOnce, kOfSize * state.bodies[at(pair.bodyB)].reach);
  const Real share =
      settings.continuous ? std::min(kMost, SoftSettings().rise * state.lastStep) : kMost;
  const Real separation = pair.manifold.points[at(point)].separation;
  if (separation > 0 && !(pair.force[at(point)] > 0 && separation <= gap)) return 0;
  const Real way = -separation;
  return way > atOnce ? atOnce + share * (way - atOnce) : way;
}

// What rounding may leave of a separation.
Real littleWay(const WorldState& state, const PairSlot& pair) {
  constexpr Real kRoundings = 16 * std::numeric_limits<Real>::epsilon();
  const BodySlot& b = state.bodies[at(pair.bodyB)];
  return kRoundings * (b.position.cwiseAbs().maxCoeff() + b.reach);
}

}  // namespace

bool projectPositions(WorldState& state, std::span<const Index> bodies,
                      std::span<const Index> pairs) {
  return projectPositions(state, bodies, pairs, state.settings.restTolerance);
}

bool projectPositions(WorldState& state, std::span<const Index> bodies,
                      std::span<const Index> pairs, Real gap) {
  Workspace& work = state.work;
  // Is anything off?
  std::int64_t off = 0;
  for (const Index index : pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    bool one = false;
    for (int i = 0; i < pair.manifold.count; ++i) {
      one = one || std::abs(wantedWay(state, pair, i, gap)) > littleWay(state, pair);
    }
    off += one ? 1 : 0;
  }
  if (off == 0) return false;
  state.counters.projections += off;

  // The bodies' velocities are ways here, and nothing moves yet.
  gather(state, bodies, pairs);
  for (MovingBody& body : work.moving) body.velocity = Velocity();
  work.patches.clear();
  work.blocks.clear();
  for (const Index index : pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    WorkPatch one = patchOf(state, index);
    one.patch.friction = 0;
    for (int i = 0; i < pair.manifold.count; ++i) {
      // Points that are apart must not be pushed into each other.
      PatchPoint point = armsOf(state, pair, i);
      const Real separation = pair.manifold.points[at(i)].separation;
      const bool closed = separation <= 0 || wantedWay(state, pair, i, gap) != 0;
      point.target = closed ? wantedWay(state, pair, i, gap) : -separation;
      addPoint(one, i, point);
    }
    if (one.patch.count == 0) continue;
    work.patches.push_back(one);
    work.blocks.push_back(prepareBlock(one.patch, work.moving));
    // What carried and came off is pulled back. So is what is that near in single steps, where
    // stacks would come apart by roundings; steps whose error is looked at must not be pulled so.
    for (int k = 0; k < one.patch.count; ++k) {
      const Real target = one.patch.points[at(k)].target;
      work.blocks.back().holds[at(k)] = state.longSteps
                                            ? wantedWay(state, pair, one.pointOf[at(k)], gap) < 0
                                            : target < 0 && -target <= gap;
    }
  }

  // Sweeps; a contact that is to close is a row that pulls, too.
  constexpr int kSweeps = 10;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    Real change = 0;
    for (ContactBlock& block : work.blocks) {
      MovingBody &a = work.moving[at(block.bodyA)], &b = work.moving[at(block.bodyB)];
      for (int i = 0; i < block.count; ++i) {
        const Real missing = block.targets[at(i)] - speedAtEnd(block.normals[at(i)], a, b);
        const bool pulls = block.holds[at(i)];
        const Real wanted = block.impulses[at(i)] + block.masses[at(i)] * missing;
        const Real total = pulls ? wanted : std::max(Real(0), wanted);
        const Real added = total - block.impulses[at(i)];
        block.impulses[at(i)] = total;
        pushAlong(block.normals[at(i)], added, a, b);
        if (block.masses[at(i)] > 0)
          change = std::max(change, std::abs(added) / block.masses[at(i)]);
      }
    }
    if (change < 1e-15) break;
  }

  const Real share = paidShare(state, bodies);
  if (share < 1) {
    for (MovingBody& body : work.moving) {
      body.velocity = {share * body.velocity.linear, share * body.velocity.angular};
    }
  }
  for (std::size_t i = 0; i < work.blocks.size(); ++i) {
    const ContactBlock& block = work.blocks[i];
    PairSlot& pair = state.pairs[at(work.patches[i].pair)];
    for (int k = 0; k < block.count; ++k) {
      const MovingBody &a = work.moving[at(block.bodyA)], &b = work.moving[at(block.bodyB)];
      pair.manifold.points[at(work.patches[i].pointOf[at(k)])].separation +=
          speedAtEnd(block.normals[at(k)], a, b);
    }
  }
  for (const Index index : bodies) {
    BodySlot& body = state.bodies[at(index)];
    const Velocity& way = work.moving[at(body.local)].velocity;
    body.position += way.linear;
    payForWay(state, state.islands[at(body.island)], body, way.linear);
    const Matrix3 before = body.pose.R_WB;
    if (way.angular != Vector3::Zero()) {
      body.orientation = integrateOrientation(body.orientation, way.angular, 1);
      dropAnchor(state, body);
    }
    refreshPose(body);
    // What is pushed out of an overlap turns, and must not turn faster for it; what keeps a contact
    // closed is far less.
    constexpr Real kVisible = 1e-7;
    if (!body.turnsEvenly && way.angular.norm() > kVisible) keepTurningEnergy(body, before);
  }
  return true;
}

void projectRounds(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                   Real end) {
  bool carries = false;
  for (const Index index : pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    const ShapeSlot &a = state.shapes[at(pair.shapeA)], &b = state.shapes[at(pair.shapeB)];
    if (!isRound(a) || !isRound(b)) return;
    carries = carries || (pair.force[0] > 0 && isDynamic(state.bodies[at(pair.bodyA)]));
  }
  if (!carries) return;
  constexpr int kRounds = 8;
  for (int round = 0; round < kRounds; ++round) {
    for (const Index index : pairs) remakeManifold(state, index, end, 0);
    if (!projectPositions(state, bodies, pairs)) return;
  }
}

}  // namespace carom::world
